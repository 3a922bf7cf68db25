#pragma once

/// Who drives the boat when nobody else does.
#include "speedboat/course.h"
#include "speedboat/motorboat.h"

namespace speedboat {

/// Steers for the water beside the next buoy, with less throttle while it lies far off the bow.
class Pilot {
public:
    struct Orders {
        real throttle = 0, steering = 0, tilt = 0;  ///< as Motorboat takes them
    };

    /// For a step of `duration`, s.
    Orders drive(const Motorboat &boat, const Course &course, real duration);
    void startOver() { orders = Orders(); }

private:
    Orders orders;
};

}  // namespace speedboat
