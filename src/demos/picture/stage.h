#pragma once

/// Draws a scene's moments: cameras, solids, shadows, arrows and trails.
#include "picture/canvas.h"
#include "picture/scene.h"

#include <deque>

namespace demo {

class Stage {
public:
    /// The scene must outlive the stage, and keep its bodies.
    explicit Stage(const Scene &scene);

    Viewpoint viewpoint;      ///< at first the scene's first one
    real zoom = 1;            ///< 2: everything twice as large
    bool showForces = false;  ///< the surfaces' forces as arrows

    /// Goes on to the scene's next viewpoint.
    void nextViewpoint();

    /// Draws all but text onto the canvas, which it begins. `elapsed` s have gone by since the last frame:
    /// the chase camera swings round with a little delay.
    void draw(Canvas &canvas, int columns, int rows, const Frame &frame, real elapsed);

    /// Lengthens the trails without drawing; draw() does so too.
    void follow(const Frame &frame);

    static std::string getName(Viewpoint viewpoint);

private:
    Camera aim(const Frame &frame, real elapsed);
    void drawBodies(Canvas &canvas, const Frame &frame) const;
    void drawTrails(Canvas &canvas) const;

    const Scene &scene;
    Vector3 behind;  ///< horizontal: where the chase camera looks along; zero at first
    std::vector<std::deque<Vector3>> trails;  ///< of each body, the latest place last
};

}  // namespace demo
