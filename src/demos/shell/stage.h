#pragma once

/// Draws a demonstration's moments: cameras, solids, shadows and arrows.
#include "picture/canvas.h"
#include "shell/demo.h"

namespace demo {

enum class Viewpoint { SPECTATOR, CHASE, SIDE };

/// What the two frames' moments make together, `share` of the way from a to b; b as it is if it is a cut.
Frame interpolated(const Frame &a, const Frame &b, real share);

class Stage {
public:
    /// The profile must outlive the stage.
    explicit Stage(const Profile &p) : profile(p) {}

    Viewpoint viewpoint = Viewpoint::CHASE;
    real zoom = 1;            ///< 2: everything twice as large
    bool showForces = false;  ///< the surfaces' forces as arrows

    /// Draws all but text onto the canvas, which it begins. `elapsed` s have gone by since the last frame:
    /// the chase camera swings round with a little delay.
    void draw(Canvas &canvas, int columns, int rows, const Frame &frame, real elapsed);

    static std::string getName(Viewpoint viewpoint);

private:
    Camera aim(const Frame &frame, real elapsed);

    const Profile &profile;
    Vector3 behind;  ///< horizontal: where the chase camera looks along; zero at first
};

}  // namespace demo
