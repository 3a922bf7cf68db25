#include "airrace/lap.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "base/text.h"

namespace airrace {

using cyclone::Quaternion;
using cyclone::Vector3;

namespace {

constexpr real LONGEST = 1e6;  // s
constexpr std::size_t POSE_WORDS = 7;

Pose between(const Pose &a, const Pose &b, real share) {
    return {demo::mix(a.position, b.position, share),
            Quaternion::linearInterpolate(a.orientation, b.orientation, share)};
}

[[noreturn]] void fail(const std::string &why) { throw std::runtime_error(why); }

real readNumber(const std::string &word) {
    const std::optional<real> number = demo::readNumber(word);
    if (!number) fail("'" + word + "' is not a number");
    return *number;
}

Pose readPose(const std::vector<std::string> &words) {
    if (words.size() != POSE_WORDS + 1) fail("expected 'at' and seven numbers");
    real n[POSE_WORDS];
    for (std::size_t i = 0; i < POSE_WORDS; ++i) n[i] = readNumber(words[i + 1]);
    const real square = n[3] * n[3] + n[4] * n[4] + n[5] * n[5] + n[6] * n[6];
    if (!(square > 0.99 && square < 1.01)) fail("the last four numbers are not an orientation");
    return {Vector3(n[0], n[1], n[2]), Quaternion(n[3], n[4], n[5], n[6])};
}

void requireComplete(const std::string &aircraft, const Lap &lap) {
    if (lap.time == 0) fail("the lap of the " + aircraft + " has no time");
    if (lap.poses.size() != lap.countPoses())
        fail("the lap of the " + aircraft + " has " + std::to_string(lap.poses.size()) +
             " places, and its time asks for " + std::to_string(lap.countPoses()));
}

}  // namespace

// ---- A lap

std::size_t Lap::countPoses() const {
    std::size_t count = 1;  // the finish
    while (static_cast<real>(count - 1) * INTERVAL < time) ++count;
    return count;
}

Pose Lap::getPose(real sinceStart) const {
    const real since = cyclone::real_clamp(sinceStart, 0, time);
    const std::size_t n = std::min(static_cast<std::size_t>(since / INTERVAL), poses.size() - 2);
    const real begin = static_cast<real>(n) * INTERVAL, end = n + 2 == poses.size() ? time : begin + INTERVAL;
    return between(poses[n], poses[n + 1], (since - begin) / (end - begin));
}

void LapRecorder::start(real time) {
    startTime = time;
    poses.clear();
}

void LapRecorder::add(const Pose &from, const Pose &to, real time, real duration) {
    for (;;) {
        const real next = startTime + static_cast<real>(poses.size()) * Lap::INTERVAL;
        if (next >= time) return;
        poses.push_back(between(from, to, (next - time + duration) / duration));
    }
}

Lap LapRecorder::finish(real lapTime, const Pose &from, const Pose &to, real time, real duration) {
    Lap lap;
    lap.time = lapTime;
    add(from, to, time, duration);
    lap.poses = std::move(poses);
    const Pose finish = between(from, to, (startTime + lapTime - time + duration) / duration);
    lap.poses.resize(lap.countPoses() - 1, finish);  // none that is later
    lap.poses.push_back(finish);
    return lap;
}

// ---- The best ones

const Lap *BestLaps::find(const std::string &aircraft) const {
    const auto at = laps.find(aircraft);
    return at == laps.end() ? nullptr : &at->second;
}

BestLaps BestLaps::read(const std::string &text, const std::vector<std::string> &aircraft) {
    BestLaps best;
    std::string of;  // whose lap is being read
    const auto readLine = [&](const std::vector<std::string> &words) {
        if (words[0] == "aircraft") {
            if (!of.empty()) requireComplete(of, best.laps[of]);
            if (words.size() != 2 || std::count(aircraft.begin(), aircraft.end(), words[1]) == 0)
                fail("there is no such aircraft");
            of = words[1];
            if (best.find(of)) fail("the " + of + " is there twice");
            best.laps[of] = Lap();
        } else if (of.empty()) {
            fail("expected 'aircraft'");
        } else if (words[0] == "lap") {
            if (words.size() != 2) fail("expected 'lap' and a time");
            const real time = readNumber(words[1]);
            if (!(time > 0 && time <= LONGEST)) fail("'" + words[1] + "' is not a lap's time");
            best.laps[of].time = time;
        } else if (words[0] == "at") {
            best.laps[of].poses.push_back(readPose(words));
        } else {
            fail("'" + words[0] + "' is none of aircraft, lap, at");
        }
    };
    std::istringstream in(text);
    int number = 0;
    try {
        for (std::string line; std::getline(in, line);) {
            ++number;
            std::istringstream rest(line.substr(0, line.find('#')));
            std::vector<std::string> words;
            for (std::string word; rest >> word;) words.push_back(word);
            if (!words.empty()) readLine(words);
        }
        if (!of.empty()) requireComplete(of, best.laps[of]);
    } catch (const std::runtime_error &mistake) {
        fail("line " + std::to_string(number) + ": " + mistake.what());
    }
    return best;
}

std::string BestLaps::getText() const {
    std::string text =
        "# Best laps: seconds, and every 0.1 s where the aircraft was: x y z in metres,\n"
        "# and how it lay: its quaternion r i j k.\n";
    for (const auto &[aircraft, lap] : laps) {
        text += "aircraft " + aircraft + "\nlap " + demo::shortest(lap.time) + "\n";
        for (const Pose &pose : lap.poses) {
            text += "at";
            for (const real metres : {pose.position.x, pose.position.y, pose.position.z})
                text += " " + demo::fixed(metres, 2);
            for (const real part :
                 {pose.orientation.r, pose.orientation.i, pose.orientation.j, pose.orientation.k})
                text += " " + demo::fixed(part, 4);
            text += "\n";
        }
    }
    return text;
}

}  // namespace airrace
