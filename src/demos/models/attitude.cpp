#include "models/attitude.h"

#include "base/angle.h"
#include "base/text.h"

namespace demo {

using cyclone::real_atan2;
using cyclone::Vector3;

real headingOf(const RigidBody &body) { return bearing(body.getTransform().getAxisVector(0)); }

real pitchOf(const RigidBody &body) {
    const Vector3 nose = body.getTransform().getAxisVector(0);
    return real_atan2(nose.y, horizontalLength(nose));
}

real bankOf(const RigidBody &body) {
    return real_atan2(-body.getTransform().getAxisVector(2).y, body.getTransform().getAxisVector(1).y);
}

std::string whereabouts(const RigidBody &body, const Vector3 &place) {
    const Vector3 way = place - body.getPosition();
    return fixed(horizontalLength(way), 0) + "m " + sided(wrapAngle(bearing(way) - headingOf(body)));
}

}  // namespace demo
