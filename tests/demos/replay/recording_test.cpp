#include "replay/recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <locale>
#include <map>
#include <sstream>
#include <stdexcept>

namespace {

using namespace demo;

constexpr real degree = 3.14159265358979323846 / 180;

// A reader of its own for what a page carries: JSON, and columns as the viewer decodes them.

struct Json {
    real number = 0;
    std::string text;
    std::vector<Json> items;
    std::map<std::string, Json> members;
    const Json &operator[](const std::string &name) const { return members.at(name); }
};

class JsonReader {
public:
    explicit JsonReader(const std::string &json) : text(json) {}

    Json read() {
        skipSpace();
        Json value;
        if (text.at(at) == '{') {
            readList('}', [&] {
                const std::string name = readString();
                skipSpace();
                EXPECT_EQ(text.at(at++), ':');
                value.members[name] = read();
            });
        } else if (text.at(at) == '[') {
            readList(']', [&] { value.items.push_back(read()); });
        } else if (text.at(at) == '"') {
            value.text = readString();
        } else {
            readWord(value);
        }
        return value;
    }

private:
    void skipSpace() {
        while (text.at(at) == ' ' || text.at(at) == '\n') ++at;
    }

    template <class ReadItem>
    void readList(char end, ReadItem readItem) {
        ++at;
        skipSpace();
        while (text.at(at) != end) {
            readItem();
            skipSpace();
            if (text.at(at) == ',') ++at;
            skipSpace();
        }
        ++at;
    }

    std::string readString() {
        std::string result;
        for (++at; text.at(at) != '"'; ++at) {
            EXPECT_GE(static_cast<unsigned char>(text.at(at)), 0x20) << "a control character in a string";
            if (text.at(at) != '\\') {
                result += text.at(at);
            } else if (text.at(at + 1) == 'u') {
                result += static_cast<char>(std::stoi(text.substr(at + 2, 4), nullptr, 16));
                at += 5;
            } else {
                result += text.at(++at);
            }
        }
        ++at;
        return result;
    }

    void readWord(Json &value) {
        const std::size_t end = text.find_first_of(",]} \n", at);
        const std::string word = text.substr(at, end - at);
        at = end;
        if (word == "true" || word == "false") {
            value.number = word == "true";
            return;
        }
        std::istringstream digits(word);
        digits.imbue(std::locale::classic());
        digits >> value.number;
        EXPECT_TRUE(digits && digits.peek() == EOF) << word;
    }

    const std::string &text;
    std::size_t at = 0;
};

std::string fromBase64(const std::string &text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text.substr(0, text.find('='))) {
        bits = bits << 6 | static_cast<unsigned>(digits.find(c));
        count += 6;
        if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255);
    }
    return bytes;
}

std::uint32_t littleEndian(const std::string &bytes, std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return value;
}

real at(const Json &column, std::size_t frame) {
    if (column.members.count("u16")) {
        const std::uint32_t steps = littleEndian(fromBase64(column["u16"].text), 2 * frame, 2);
        return column["least"].number + column["step"].number * steps;
    }
    if (column.members.count("f32")) {
        const std::uint32_t bits = littleEndian(fromBase64(column["f32"].text), 4 * frame, 4);
        float value = 0;
        std::memcpy(&value, &bits, sizeof value);
        return static_cast<real>(value);
    }
    return column.number;
}

Vector3 vectorAt(const Json &columns, std::size_t frame) {
    return Vector3(at(columns.items[0], frame), at(columns.items[1], frame), at(columns.items[2], frame));
}

/// The part's pose in the world, as the viewer puts it together.
Pose poseAt(const Json &data, std::size_t part, std::size_t frame, std::size_t body = 0) {
    const Json &columns = data["bodies"].items[body]["parts"].items[part], &turn = columns["orientation"];
    Pose pose{vectorAt(columns["position"], frame),
              Quaternion(at(turn.items[0], frame), at(turn.items[1], frame), at(turn.items[2], frame),
                         at(turn.items[3], frame))};
    pose.orientation.normalise();
    if (columns["onBody"].number == 0) return pose;
    const Pose root = poseAt(data, 0, frame, body);
    return {root.position + root.orientation.rotate(pose.position), root.orientation * pose.orientation};
}

std::string pageOf(const Recording &recording) {
    std::ostringstream page;
    writePage(page, recording);
    return page.str();
}

Json dataOf(const std::string &page) {
    const std::string opening = "<script id=\"recording\" type=\"application/json\">";
    const std::size_t start = page.find(opening) + opening.size();
    const std::string data = page.substr(start, page.find("</script>", start) - start) + '\n';
    return JsonReader(data).read();
}

/// The angle between two orientations, q and −q being the same one.
real angleBetween(const Quaternion &a, const Quaternion &b) {
    const Quaternion d = a.conjugate() * b;
    return 2 * std::atan2(std::sqrt(d.i * d.i + d.j * d.j + d.k * d.k), std::fabs(d.r));
}

// A vehicle that climbs in a turn and rolls right round, with parts that are fixed to it, turn on it or stay
// behind.

Subject vehicle(std::size_t parts, std::size_t channels) {
    Subject subject;
    subject.title = "Climbing turn";
    subject.kind = "flight";
    subject.scene.bodies.resize(1);
    for (std::size_t n = 0; n < parts; ++n) {
        Part part;
        part.name = "part " + std::to_string(n);
        part.faces = {{{{0, 0, 0}, {1, 0, 0}, {0, 0.12345, 0}}, {200, 16, 1}}};
        subject.scene.bodies[0].parts.push_back(part);
    }
    for (std::size_t n = 0; n < channels; ++n)
        subject.channels.push_back({"channel " + std::to_string(n), "m", "panel"});
    return subject;
}

Frame momentOf(const Subject &subject, real time, std::size_t arrows) {
    Frame frame;
    frame.time = time;
    const Quaternion orientation =
        Quaternion::fromAxisAngle({0, 1, 0}, -0.3 * time) * Quaternion::fromAxisAngle({1, 0, 0}, 1.7 * time);
    const Pose body{{80 * std::sin(0.3 * time), 2 + 3 * time, 80 * std::cos(0.3 * time)}, orientation};
    for (std::size_t n = 0; n < subject.scene.bodies[0].parts.size(); ++n) {
        const real number = static_cast<real>(n);
        const Vector3 hinge(0.1 * number, 0.2, -0.3 * number);
        const Quaternion turn =
            Quaternion::fromAxisAngle({0, 0, 1}, (n % 2 ? 0.00019 : 0.4) * std::sin(number * time));
        Pose pose{body.position + orientation.rotate(hinge), orientation * turn};
        if (n == 0) pose = body;
        if (n == 3) pose = {{-250, 0, 400}, Quaternion::fromAxisAngle({0, 1, 0}, 1)};
        frame.poses.push_back(pose);
    }
    for (std::size_t n = 0; n < arrows; ++n) {
        const real number = static_cast<real>(n);
        frame.arrows.push_back({"arrow " + std::to_string(n),
                                body.position + orientation.rotate({0, 0, number}),
                                orientation.rotate({0, 1 + std::sin(number + time), 0}),
                                {1, 2, 3}});
    }
    frame.windspeed = {5 + std::sin(time), 0, std::cos(0.7 * time)};
    return frame;
}

std::vector<real> valuesOf(const Subject &subject, real time) {
    std::vector<real> values;
    for (std::size_t n = 0; n < subject.channels.size(); ++n)
        values.push_back(1000 * std::sin(time + static_cast<real>(n)));
    return values;
}

Recording turn(std::size_t parts, std::size_t arrows, std::size_t channels, std::size_t frames) {
    Recording recording(vehicle(parts, channels));
    const Subject &subject = recording.getSubject();
    for (std::size_t n = 0; n < frames; ++n) {
        const real time = static_cast<real>(n) / 30;
        recording.append(momentOf(subject, time, arrows), valuesOf(subject, time));
    }
    return recording;
}

TEST(RecordingPage, CarriesEveryFrameWithinTheStatedError) {
    const Recording recording = turn(5, 2, 2, 300);
    const Json data = dataOf(pageOf(recording));
    ASSERT_EQ(data["frames"].number, 300);
    for (std::size_t n = 0; n < 300; n += 7) {
        const Frame &frame = recording.getFrames()[n];
        EXPECT_NEAR(at(data["time"], n), frame.time, 1e-5);
        EXPECT_LT((vectorAt(data["windspeed"], n) - frame.windspeed).magnitude(), 0.002);
        for (std::size_t part = 0; part < 5; ++part) {
            const Pose pose = poseAt(data, part, n);
            EXPECT_LT((pose.position - frame.poses[part].position).magnitude(), 0.001) << part << " at " << n;
            EXPECT_LT(angleBetween(pose.orientation, frame.poses[part].orientation), 0.01 * degree) << part;
        }
        for (std::size_t arrow = 0; arrow < 2; ++arrow) {
            const Json &columns = data["arrows"].items[arrow];
            const Pose body = poseAt(data, 0, n);
            const Vector3 tail = body.position + body.orientation.rotate(vectorAt(columns["tail"], n));
            EXPECT_LT((tail - frame.arrows[arrow].tail).magnitude(), 0.001);
            EXPECT_LT((vectorAt(columns["vector"], n) - frame.arrows[arrow].vector).magnitude(), 0.001);
        }
        for (std::size_t channel = 0; channel < 2; ++channel)
            EXPECT_NEAR(at(data["channels"].items[channel]["values"], n), recording.getValues(channel)[n],
                        2000 / 1e5);
    }
}

TEST(RecordingPage, CarriesWhatTheViewerNeedsBesides) {
    Subject subject = vehicle(2, 1);
    subject.scene.surroundings.terrain = Terrain::SEA;
    subject.scene.surroundings.waves = {{0.25, 12, -0.5, 1.5}};
    subject.scene.cameras.distance = 15;
    subject.scene.cameras.height = 0.5;
    subject.scene.newtonsPerMetre = 40;
    subject.scene.bodies[0].parts[1].twoSided = true;
    subject.scene.paint = {{"runway", {{{{0, 0, 1}, {2, 0, 1}, {2, 0, 0}}, {9, 9, 9}}}, false},
                           {"stripe", {{{{0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, {255, 0, 0}}}, false}};
    Recording recording(subject);
    recording.append(momentOf(subject, 0.5, 1), {0.5});
    Frame restart = momentOf(subject, 0.75, 1);
    restart.cut = true;
    recording.append(restart, {0.75});
    recording.addEvent(0.625, "crashed");
    recording.setSummary("two lines\nof summary");

    const Json data = dataOf(pageOf(recording));
    EXPECT_EQ(data["title"].text, "Climbing turn");
    EXPECT_EQ(data["kind"].text, "flight");
    EXPECT_EQ(data["summary"].text, "two lines\nof summary");
    EXPECT_EQ(data["terrain"].text, "sea");
    const Json &wave = data["waves"].items.at(0);
    EXPECT_EQ(wave["amplitude"].number, 0.25);
    EXPECT_EQ(wave["wavelength"].number, 12);
    EXPECT_EQ(wave["direction"].number, -0.5);
    EXPECT_EQ(wave["phase"].number, 1.5);
    // ω² = g·k: on deep water 12 m long waves take √(2π·12 m/g) = 2.7723 s.
    EXPECT_NEAR(2 * cyclone::REAL_PI / wave["frequency"].number, 2.7723, 1e-4);
    EXPECT_EQ(data["cameras"]["distance"].number, 15);
    EXPECT_EQ(data["cameras"]["height"].number, 0.5);
    EXPECT_EQ(data["newtonsPerMetre"].number, 40);
    EXPECT_EQ(data["events"].items.at(0)["time"].number, 0.625);
    EXPECT_EQ(data["events"].items.at(0)["text"].text, "crashed");
    ASSERT_EQ(data["cuts"].items.size(), 1u);
    EXPECT_EQ(data["cuts"].items[0].number, 1);
    EXPECT_EQ(data["arrows"].items.at(0)["name"].text, "arrow 0");
    EXPECT_EQ(data["arrows"].items[0]["colour"].text, "#010203");
    EXPECT_EQ(data["channels"].items.at(0)["unit"].text, "m");
    EXPECT_EQ(data["channels"].items[0]["panel"].text, "panel");
    ASSERT_EQ(data["paint"].items.size(), 2u);
    EXPECT_EQ(data["paint"].items[1]["colour"].text, "#ff0000");
    EXPECT_EQ(data["paint"].items[1]["corners"].items.at(3).number, 1);
    const Json &part = data["bodies"].items.at(0)["parts"].items.at(1);
    EXPECT_EQ(part["name"].text, "part 1");
    EXPECT_EQ(part["twoSided"].number, 1);
    const Json &face = part["faces"].items.at(0);
    EXPECT_EQ(face["colour"].text, "#c81001");
    ASSERT_EQ(face["corners"].items.size(), 9u);
    EXPECT_NEAR(face["corners"].items[7].number, 0.12345, 0.00005001);
}

TEST(RecordingPage, KeepsWhatStaysBehindInTheWorldAndTheRestOnTheBody) {
    const Json data = dataOf(pageOf(turn(5, 0, 0, 60)));
    const real onBody[] = {0, 1, 1, 0, 1};
    for (std::size_t part = 0; part < 5; ++part)
        EXPECT_EQ(data["bodies"].items[0]["parts"].items[part]["onBody"].number, onBody[part]);
}

TEST(RecordingPage, CarriesSeveralBodiesEachWithItsParts) {
    Subject subject = vehicle(2, 0);
    subject.scene.bodies.push_back({subject.scene.bodies[0].parts, true, true});
    subject.scene.fixtures = subject.scene.bodies[0].parts;
    subject.scene.cameras.viewpoints = {Viewpoint::PLANE};
    subject.scene.surroundings.terrain = Terrain::SPACE;
    Recording recording(subject);
    for (int n = 0; n < 30; ++n) {
        Frame frame = momentOf(subject, n / 30.0, 0);  // the first body's poses
        Frame other = momentOf(subject, 7 + n / 30.0, 0);
        frame.poses.insert(frame.poses.end(), other.poses.begin(), other.poses.end());
        recording.append(frame, {});
    }
    const Json data = dataOf(pageOf(recording));
    EXPECT_EQ(data["terrain"].text, "space");
    EXPECT_EQ(data["flat"].number, 1);
    EXPECT_EQ(data["fixtures"].items.size(), 2u);
    ASSERT_EQ(data["bodies"].items.size(), 2u);
    EXPECT_EQ(data["bodies"].items[0]["ghost"].number, 0);
    EXPECT_EQ(data["bodies"].items[1]["ghost"].number, 1);
    EXPECT_EQ(data["bodies"].items[1]["trail"].number, 1);
    for (std::size_t body = 0; body < 2; ++body)
        for (std::size_t part = 0; part < 2; ++part) {
            const Pose pose = poseAt(data, part, 29, body),
                       expected = recording.getFrames()[29].poses[2 * body + part];
            EXPECT_LT((pose.position - expected.position).magnitude(), 0.001);
            EXPECT_LT(angleBetween(pose.orientation, expected.orientation), 0.01 * degree);
        }
    EXPECT_EQ(data["bodies"].items[1]["parts"].items[1]["onBody"].number, 1);
}

TEST(RecordingPage, IsSmallForAMinute) {
    const std::size_t size = pageOf(turn(15, 8, 10, 1800)).size();
    EXPECT_LT(size, 800'000u);
}

TEST(RecordingPage, KeepsTextFromEndingTheScript) {
    const std::string wicked = "</script><script>alert(\"1\")</script> <!-- & \\ \t\n\x01 \xc3\xbc";
    Subject subject = vehicle(1, 1);
    const auto page = [&] {
        Recording recording(subject);
        recording.append(momentOf(subject, 0, 1), {0});
        recording.addEvent(0, subject.title);
        recording.setSummary(subject.title);
        return pageOf(recording);
    };
    const auto tags = [](const std::string &text) { return std::count(text.begin(), text.end(), '<'); };
    const auto usual = tags(page());
    subject.title = subject.kind = subject.scene.bodies[0].parts[0].name = subject.channels[0].panel = wicked;
    const std::string text = page();
    EXPECT_EQ(tags(text), usual);
    const Json data = dataOf(text);
    EXPECT_EQ(data["title"].text, wicked);
    EXPECT_EQ(data["summary"].text, wicked);
    EXPECT_EQ(data["events"].items.at(0)["text"].text, wicked);
    EXPECT_EQ(data["bodies"].items.at(0)["parts"].items.at(0)["name"].text, wicked);
    EXPECT_EQ(data["channels"].items.at(0)["panel"].text, wicked);
}

struct CommaForPoint : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(RecordingPage, IsTheSameInEveryLocale) {
    const Recording recording = turn(2, 1, 1, 10);
    const std::string usual = pageOf(recording);
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaForPoint));
    const std::string abroad = pageOf(recording);
    std::locale::global(before);
    EXPECT_EQ(usual, abroad);
}

TEST(RecordingPage, NeedsAFrame) {
    const Recording recording(vehicle(1, 0));
    std::ostringstream page;
    EXPECT_THROW(writePage(page, recording), std::invalid_argument);
    EXPECT_TRUE(page.str().empty());
}

/// The text with which an appended frame is refused; empty when it isn't.
std::string refusalOf(Recording &recording, const Frame &frame, const std::vector<real> &values) {
    const std::size_t before = recording.getFrames().size();
    try {
        recording.append(frame, values);
    } catch (const std::invalid_argument &error) {
        EXPECT_EQ(recording.getFrames().size(), before);
        return error.what();
    }
    return "";
}

TEST(Recording, RefusesAFrameThatDoesNotFit) {
    Recording recording(vehicle(3, 2));
    const Subject &subject = recording.getSubject();
    recording.append(momentOf(subject, 1, 2), {1, 1});
    const real nan = std::nan("");
    const auto refusedWith = [&](const std::vector<real> &values, auto spoil) {
        Frame frame = momentOf(subject, 2, 2);
        spoil(frame);
        return refusalOf(recording, frame, values).rfind("Recording::append: ", 0) == 0;
    };
    const auto refused = [&](auto spoil) { return refusedWith({1, 2}, spoil); };
    EXPECT_TRUE(refused([](Frame &f) { f.poses.pop_back(); }));
    EXPECT_TRUE(refusedWith({1, 2, 3}, [](Frame &) {}));
    EXPECT_TRUE(refused([](Frame &f) { f.arrows.pop_back(); }));
    EXPECT_TRUE(refused([](Frame &f) { f.arrows[0].name = "another"; }));
    EXPECT_TRUE(refused([](Frame &f) { f.time = 1; }));
    EXPECT_TRUE(refused([&](Frame &f) { f.time = nan; }));
    EXPECT_TRUE(refused([&](Frame &f) { f.poses[2].position.y = nan; }));
    EXPECT_TRUE(refused([&](Frame &f) { f.poses[1].orientation = Quaternion(0, 0, 0, 0); }));
    EXPECT_TRUE(refused([&](Frame &f) { f.arrows[1].vector.x = nan; }));
    EXPECT_TRUE(refused([&](Frame &f) { f.windspeed.z = nan; }));
    EXPECT_TRUE(refusedWith({nan, 2}, [](Frame &) {}));
    EXPECT_FALSE(refused([](Frame &) {}));
}

TEST(Recording, RefusesASubjectThatCannotBeDrawn) {
    EXPECT_THROW(Recording{Subject()}, std::invalid_argument);
    Subject subject = vehicle(1, 0);
    subject.scene.bodies[0].parts[0].faces[0].corners[1].x = std::nan("");
    EXPECT_THROW(Recording{subject}, std::invalid_argument);
    subject = vehicle(1, 0);
    subject.scene.surroundings.waves = {{1, 0, 0, 0}};
    EXPECT_THROW(Recording{subject}, std::invalid_argument);
    subject = vehicle(1, 0);
    subject.scene.newtonsPerMetre = -1;
    EXPECT_THROW(Recording{subject}, std::invalid_argument);
    subject = vehicle(1, 0);
    subject.scene.cameras.distance = 0;
    EXPECT_THROW(Recording{subject}, std::invalid_argument);
    subject = vehicle(1, 0);
    subject.scene.cameras.viewpoints.clear();
    EXPECT_THROW(Recording{subject}, std::invalid_argument);
}

TEST(Recording, RefusesAnEventWithoutATime) {
    Recording recording(vehicle(1, 0));
    EXPECT_THROW(recording.addEvent(std::nan(""), "never"), std::invalid_argument);
    EXPECT_TRUE(recording.getEvents().empty());
}

}  // namespace
