#include "replay/recording.h"

#include "base/text.h"
#include "replay/viewer_page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <utility>

namespace demo {

using cyclone::detail::require;

namespace {

// What rounding may cost, in a column of numbers.
constexpr real POSITION_TOLERANCE = 0.0004;  // m
constexpr real ORIENTATION_TOLERANCE = 2e-5;
constexpr real WIND_TOLERANCE = 0.001;  // m/s
constexpr real TIME_TOLERANCE = 1e-7;   // s: below a float's, which is then used

using Column = std::vector<real>;

std::string number(real value) { return significant(value, 9); }

/// A JSON string that is safe inside a <script> element.
std::string quoted(const std::string &text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20 || c == '"' || c == '\\' || c == '<' || c == '>' || c == '&') {
            const char *digits = "0123456789abcdef";
            result += std::string("\\u00") + digits[code >> 4] + digits[code & 15];
        } else {
            result += c;
        }
    }
    return result + '"';
}

std::string quoted(Colour colour) {
    const char *digits = "0123456789abcdef";
    std::string result = "\"#";
    for (const unsigned char level : {colour.red, colour.green, colour.blue})
        result = result + digits[level >> 4] + digits[level & 15];
    return result + '"';
}

std::string asWord(bool value) { return value ? "true" : "false"; }

/// [one,two,…]: what `write` makes of each item.
template <class Items, class Write>
std::string list(const Items &items, Write write) {
    std::string result;
    for (const auto &item : items) result += (result.empty() ? "" : ",") + write(item);
    return '[' + result + ']';
}

std::string base64(const std::string &bytes) {
    const char *digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto byte = [&](std::size_t at) -> unsigned {
        return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
    };
    std::string result;
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const unsigned three = byte(at) << 16 | byte(at + 1) << 8 | byte(at + 2);
        for (int shift = 18; shift >= 0; shift -= 6) result += digits[three >> shift & 63];
    }
    for (std::size_t i = 0; i < (3 - bytes.size() % 3) % 3; ++i) result[result.size() - 1 - i] = '=';
    return result;
}

void appendLittleEndian(std::string &bytes, std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> 8 * i & 255);
}

std::string asFloats(const Column &column) {
    std::string bytes;
    for (const real value : column) {
        const float rounded = static_cast<float>(value);
        std::uint32_t bits = 0;
        std::memcpy(&bits, &rounded, sizeof bits);
        appendLittleEndian(bytes, bits, 4);
    }
    return "{\"f32\":\"" + base64(bytes) + "\"}";
}

std::string asSteps(const Column &column, real least, real step) {
    std::string bytes;
    for (const real value : column)
        appendLittleEndian(bytes, static_cast<std::uint32_t>(std::lround((value - least) / step)), 2);
    return "{\"least\":" + number(least) + ",\"step\":" + number(step) + ",\"u16\":\"" + base64(bytes) +
           "\"}";
}

/// The shortest form that keeps the tolerance: one number, 16-bit steps, or single precision.
std::string encode(const Column &column, real tolerance) {
    const auto [least, most] = std::minmax_element(column.begin(), column.end());
    const real range = *most - *least, step = range / 65535;
    if (range <= tolerance) return number(*least + range / 2);
    if (step <= 1.9 * tolerance) return asSteps(column, *least, step);
    return asFloats(column);
}

/// One number of each frame.
template <class Get>
Column gather(const std::vector<Frame> &frames, Get get) {
    Column column;
    for (const Frame &frame : frames) column.push_back(get(frame));
    return column;
}

std::string encode(const std::vector<Vector3> &track, real tolerance) {
    std::vector<unsigned> axes = {0, 1, 2};
    return list(axes, [&](unsigned axis) {
        Column column;
        for (const Vector3 &v : track) column.push_back(v[axis]);
        return encode(column, tolerance);
    });
}

std::string encode(std::vector<Quaternion> track) {
    for (std::size_t n = 1; n < track.size(); ++n) {
        Quaternion &q = track[n];
        const Quaternion &last = track[n - 1];
        if (q.r * last.r + q.i * last.i + q.j * last.j + q.k * last.k < 0)
            q = Quaternion(-q.r, -q.i, -q.j, -q.k);
    }
    const real Quaternion::*const components[] = {&Quaternion::r, &Quaternion::i, &Quaternion::j,
                                                  &Quaternion::k};
    return list(components, [&](const real Quaternion::*component) {
        Column column;
        for (const Quaternion &q : track) column.push_back(q.*component);
        return encode(column, ORIENTATION_TOLERANCE);
    });
}

Vector3 seenFrom(const Pose &body, const Vector3 &point) {
    return body.orientation.conjugate().rotate(point - body.position);
}

/// How far a track goes, all axes together.
real extent(const std::vector<Vector3> &track) {
    Vector3 least = track.front(), most = least;
    for (const Vector3 &v : track)
        for (unsigned axis = 0; axis < 3; ++axis) {
            least[axis] = std::min(least[axis], v[axis]);
            most[axis] = std::max(most[axis], v[axis]);
        }
    return (most.x - least.x) + (most.y - least.y) + (most.z - least.z);
}

/// Where the part was: as seen from its body, where most parts are at rest or only turn, unless it moves
/// less in the world.
std::string encodeMotion(const std::vector<Frame> &frames, std::size_t part, std::size_t body) {
    std::vector<Vector3> inWorld, fromBody;
    std::vector<Quaternion> orientations;
    for (const Frame &frame : frames) {
        inWorld.push_back(frame.poses[part].position);
        fromBody.push_back(seenFrom(frame.poses[body], frame.poses[part].position));
    }
    const bool onBody = part != body && extent(fromBody) <= extent(inWorld);
    for (const Frame &frame : frames) {
        const Quaternion &orientation = frame.poses[part].orientation;
        orientations.push_back(onBody ? frame.poses[body].orientation.conjugate() * orientation
                                      : orientation);
    }
    return "\"onBody\":" + asWord(onBody) +
           ",\"position\":" + encode(onBody ? fromBody : inWorld, POSITION_TOLERANCE) +
           ",\"orientation\":" + encode(orientations);
}

std::string encodeFace(const Face &face) {
    return "{\"colour\":" + quoted(face.colour) + ",\"corners\":" +
           list(face.corners,
                [](const Vector3 &corner) {
                    const auto rounded = [](real value) { return number(std::round(value * 1e4) / 1e4); };
                    return rounded(corner.x) + ',' + rounded(corner.y) + ',' + rounded(corner.z);
                }) +
           '}';
}

std::string encodeSolid(const Part &part) {
    return "\"name\":" + quoted(part.name) + ",\"twoSided\":" + asWord(part.twoSided) +
           ",\"faces\":" + list(part.faces, encodeFace);
}

std::string encodeBodies(const Recording &recording) {
    std::size_t index = 0;
    return list(recording.getSubject().scene.bodies, [&](const Body &body) {
        const std::size_t first = index;
        return "\n{\"trail\":" + asWord(body.leavesTrail) + ",\"ghost\":" + asWord(body.isGhost) +
               ",\"parts\":" +
               list(body.parts,
                    [&](const Part &part) {
                        return "\n{" + encodeSolid(part) + ',' +
                               encodeMotion(recording.getFrames(), index++, first) + '}';
                    }) +
               '}';
    });
}

std::string encodeFixture(const Part &part) { return "\n{" + encodeSolid(part) + '}'; }

std::string encodePaint(const std::vector<Part> &paint) {
    std::vector<Face> faces;
    for (const Part &part : paint) faces.insert(faces.end(), part.faces.begin(), part.faces.end());
    return list(faces, encodeFace);
}

/// Tails as seen from the body, where most surfaces stay; vectors in the world.
std::string encodeArrows(const std::vector<Frame> &frames) {
    std::size_t index = 0;
    return list(frames.front().arrows, [&](const Arrow &arrow) {
        std::vector<Vector3> tails, vectors;
        for (const Frame &frame : frames) {
            tails.push_back(seenFrom(frame.poses[0], frame.arrows[index].tail));
            vectors.push_back(frame.arrows[index].vector);
        }
        ++index;
        return "\n{\"name\":" + quoted(arrow.name) + ",\"colour\":" + quoted(arrow.colour) +
               ",\"tail\":" + encode(tails, POSITION_TOLERANCE) +
               ",\"vector\":" + encode(vectors, POSITION_TOLERANCE) + '}';
    });
}

std::string encodeChannels(const Recording &recording) {
    std::size_t index = 0;
    return list(recording.getSubject().channels, [&](const Channel &channel) {
        const Column &column = recording.getValues(index++);
        const auto [least, most] = std::minmax_element(column.begin(), column.end());
        return "\n{\"name\":" + quoted(channel.name) + ",\"unit\":" + quoted(channel.unit) +
               ",\"panel\":" + quoted(channel.panel) +
               ",\"values\":" + encode(column, (*most - *least) / 1e5) + '}';
    });
}

const char *nameOf(Terrain terrain) {
    return terrain == Terrain::SEA ? "sea" : terrain == Terrain::SPACE ? "space" : "land";
}

std::string encodeWave(const cyclone::Waves::Train &wave) {
    return "{\"amplitude\":" + number(wave.amplitude) + ",\"wavelength\":" + number(wave.wavelength) +
           ",\"direction\":" + number(wave.direction) + ",\"frequency\":" + number(frequencyOf(wave)) +
           ",\"phase\":" + number(wave.phase) + '}';
}

std::string encodeEvent(const Event &event) {
    return "\n{\"time\":" + number(event.time) + ",\"text\":" + quoted(event.text) + '}';
}

std::string encodeCuts(const std::vector<Frame> &frames) {
    std::vector<std::size_t> cuts;
    for (std::size_t n = 0; n < frames.size(); ++n)
        if (frames[n].cut) cuts.push_back(n);
    return list(cuts, [](std::size_t n) { return std::to_string(n); });
}

std::string encodeWind(const std::vector<Frame> &frames) {
    std::vector<Vector3> winds;
    for (const Frame &frame : frames) winds.push_back(frame.windspeed);
    return encode(winds, WIND_TOLERANCE);
}

bool isFinite(const Pose &pose) {
    return pose.position.isFinite() && pose.orientation.isFinite() && pose.orientation.squareMagnitude() > 0;
}

void requireFinite(const std::vector<Part> &parts, const char *function) {
    for (const Part &part : parts)
        for (const Face &face : part.faces)
            for (const Vector3 &corner : face.corners)
                require(corner.isFinite(), function, "a corner must be finite",
                        {corner.x, corner.y, corner.z});
}

bool isFinite(const Arrow &arrow) { return arrow.tail.isFinite() && arrow.vector.isFinite(); }

}  // namespace

Recording::Recording(Subject what) : subject(std::move(what)), columns(subject.channels.size()) {
    const char *function = "Recording::Recording";
    const Scene &scene = subject.scene;
    require(!scene.bodies.empty(), function, "there must be a body at least");
    requireFinite(scene.fixtures, function);
    requireFinite(scene.paint, function);
    for (const Body &body : scene.bodies) {
        require(!body.parts.empty(), function, "a body must have a part at least");
        requireFinite(body.parts, function);
    }
    for (const cyclone::Waves::Train &wave : scene.surroundings.waves) {
        require(std::isfinite(wave.amplitude + wave.direction + wave.phase), function,
                "a wave must be finite");
        require(std::isfinite(wave.wavelength) && wave.wavelength > 0, function,
                "a wavelength must be positive and finite", {wave.wavelength});
    }
    require(std::isfinite(scene.cameras.distance) && scene.cameras.distance > 0, function,
            "the cameras' distance must be positive and finite", {scene.cameras.distance});
    require(std::isfinite(scene.cameras.height), function, "the cameras' height must be finite",
            {scene.cameras.height});
    require(!scene.cameras.viewpoints.empty(), function, "there must be a viewpoint at least");
    require(std::isfinite(scene.newtonsPerMetre) && scene.newtonsPerMetre >= 0, function,
            "newtonsPerMetre must be finite and not negative", {scene.newtonsPerMetre});
}

void Recording::append(Frame frame, const std::vector<real> &values) {
    const char *function = "Recording::append";
    const auto count = [](std::size_t size) { return static_cast<real>(size); };
    require(std::isfinite(frame.time), function, "the time must be finite", {frame.time});
    require(frames.empty() || frame.time > frames.back().time, function, "time must advance", {frame.time});
    require(frame.poses.size() == countParts(subject.scene), function, "there must be one pose for each part",
            {count(frame.poses.size())});
    require(values.size() == columns.size(), function, "there must be one value for each channel",
            {count(values.size())});
    require(frames.empty() || frame.arrows.size() == frames.front().arrows.size(), function,
            "there must be as many arrows as in the first frame", {count(frame.arrows.size())});
    for (std::size_t n = 0; n < frame.arrows.size(); ++n) {
        require(isFinite(frame.arrows[n]), function, "an arrow must be finite");
        require(frames.empty() || frame.arrows[n].name == frames.front().arrows[n].name, function,
                "the arrows must have the names that they had in the first frame");
    }
    for (Pose &pose : frame.poses) {
        require(isFinite(pose), function, "a pose must be finite, its orientation not zero");
        pose.orientation.normalise();
    }
    require(frame.windspeed.isFinite(), function, "the wind must be finite");
    for (const real value : values)
        require(std::isfinite(value), function, "a value must be finite", {value});
    for (std::size_t n = 0; n < values.size(); ++n) columns[n].push_back(values[n]);
    frames.push_back(std::move(frame));
}

void Recording::addEvent(real time, std::string text) {
    require(std::isfinite(time), "Recording::addEvent", "the time must be finite", {time});
    events.push_back({time, std::move(text)});
}

void writePage(std::ostream &out, const Recording &recording) {
    const Subject &subject = recording.getSubject();
    const std::vector<Frame> &frames = recording.getFrames();
    require(!frames.empty(), "writePage", "there must be a frame at least");
    const Scene &scene = subject.scene;
    const bool isFlat = scene.cameras.viewpoints.front() == Viewpoint::PLANE;
    const std::string data =
        "{\"title\":" + quoted(subject.title) + ",\"kind\":" + quoted(subject.kind) +
        ",\n\"summary\":" + quoted(recording.getSummary()) + ",\n\"terrain\":\"" +
        nameOf(scene.surroundings.terrain) + "\",\"flat\":" + asWord(isFlat) +
        ",\"cameras\":{\"distance\":" + number(scene.cameras.distance) +
        ",\"height\":" + number(scene.cameras.height) +
        "},\"waves\":" + list(scene.surroundings.waves, encodeWave) +
        ",\n\"newtonsPerMetre\":" + number(scene.newtonsPerMetre) +
        ",\n\"events\":" + list(recording.getEvents(), encodeEvent) +
        ",\n\"frames\":" + std::to_string(frames.size()) + ",\"cuts\":" + encodeCuts(frames) +
        ",\n\"time\":" +
        encode(gather(frames, [](const Frame &frame) { return frame.time; }), TIME_TOLERANCE) +
        ",\n\"windspeed\":" + encodeWind(frames) + ",\n\"bodies\":" + encodeBodies(recording) +
        ",\n\"fixtures\":" + list(scene.fixtures, encodeFixture) +
        ",\n\"paint\":" + encodePaint(scene.paint) + ",\n\"arrows\":" + encodeArrows(frames) +
        ",\n\"channels\":" + encodeChannels(recording) + "}";
    out << viewerPageHead << data << viewerPageTail;
}

}  // namespace demo
