#pragma once

/// Who drives the boat when nobody else does.
#include "speedboat/course.h"
#include "speedboat/motorboat.h"

namespace speedboat {

/// As Motorboat takes them.
struct Orders {
    real throttle = 0, steering = 0, tilt = 0;
};

/// The pilot's, for a step of `duration`, s, from where throttle and motor are: he steers for the water
/// beside the next buoy, with less throttle while it lies far off his course or the bow is high.
Orders drive(const Motorboat &boat, const Course &course, real duration);

}  // namespace speedboat
