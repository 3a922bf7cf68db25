#include "picture/scene.h"

namespace demo {

std::size_t countParts(const Scene &scene) {
    std::size_t count = 0;
    for (const Body &body : scene.bodies) count += body.parts.size();
    return count;
}

real frequencyOf(const cyclone::Waves::Train &train) {
    return cyclone::real_sqrt(9.81 * 2 * cyclone::REAL_PI / train.wavelength);
}

Vector3 mix(const Vector3 &a, const Vector3 &b, real share) { return a + (b - a) * share; }

const Pose NOWHERE{Vector3(0, -3000, 0), Quaternion()};

Frame interpolated(const Frame &a, const Frame &b, real share) {
    if (b.cut || a.poses.size() != b.poses.size() || a.arrows.size() != b.arrows.size()) return b;
    Frame frame = b;
    frame.time = a.time + (b.time - a.time) * share;
    frame.windspeed = mix(a.windspeed, b.windspeed, share);
    for (std::size_t n = 0; n < b.poses.size(); ++n) {
        frame.poses[n].position = mix(a.poses[n].position, b.poses[n].position, share);
        frame.poses[n].orientation =
            Quaternion::linearInterpolate(a.poses[n].orientation, b.poses[n].orientation, share);
    }
    for (std::size_t n = 0; n < b.arrows.size(); ++n) {
        frame.arrows[n].tail = mix(a.arrows[n].tail, b.arrows[n].tail, share);
        frame.arrows[n].vector = mix(a.arrows[n].vector, b.arrows[n].vector, share);
    }
    return frame;
}

}  // namespace demo
