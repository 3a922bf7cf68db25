#pragma once

/// Where one lands, and how well one has.
#include "models/verdict.h"

#include <cyclone/body.h>

#include <array>

namespace vtol {

using namespace demo;
using cyclone::Vector3;

/// A disc on the ground.
struct Pad {
    const char *name;
    Vector3 centre;
};

constexpr real PAD_RADIUS = 12;  ///< m
extern const std::array<Pad, 2> PADS;

/// By its index.
std::size_t findNearestPad(const Vector3 &place);

/// At the moment when the wheels touch.
struct Landing {
    std::size_t pad = 0;  ///< the nearest one
    real offCentre = 0;   ///< m, from its middle
    real sinkRate = 0;    ///< m/s, downwards
    real drift = 0;       ///< m/s, over the ground
    real tilt = 0;        ///< rad, between her up and up

    bool isOnPad() const { return offCentre <= PAD_RADIUS; }
};

/// velocity: the body's just before the touch, when the wheels had not changed it.
Landing measureLanding(const cyclone::RigidBody &body, const Vector3 &velocity);

Verdict judge(const Landing &landing);
/// "0.6 m/s, 1.2 m from the middle of the far pad, drifting at 0.3 m/s: good".
std::string describe(const Landing &landing);

}  // namespace vtol
