#pragma once

/// What can be drawn. The terminal's canvas and the page's viewer show the same scene.
#include <cyclone/core.h>

#include <string>
#include <vector>

namespace demo {

using cyclone::Quaternion;
using cyclone::real;
using cyclone::Vector3;

struct Colour {
    unsigned char red = 0, green = 0, blue = 0;
};

/// A flat convex polygon; corners in metres in its part's frame, counter-clockwise seen from its front.
struct Face {
    std::vector<Vector3> corners;
    Colour colour;
};

/// A solid that moves as a whole: a fuselage, a wing flap, a sail. twoSided: thin, seen from both sides.
struct Part {
    std::string name;
    std::vector<Face> faces;
    bool twoSided = false;
};

/// Where a part is: its frame to world, as a body's position (m) and orientation.
struct Pose {
    Vector3 position;
    Quaternion orientation;
};

/// A force or a wind: drawn from `tail` along `vector`, both in world metres.
struct Arrow {
    std::string name;
    Vector3 tail, vector;
    Colour colour;
};

/// One train of sinusoidal waves on the sea: y = amplitude · sin(k·(x cos d + z sin d) − ω t + phase).
struct WaveTrain {
    real amplitude = 0, wavelength = 1, direction = 0, phase = 0;  ///< m, m, rad from +X towards +Z, rad
};

/// What the vehicle moves over. The ground is the plane y = 0; the sea is y = 0 plus its waves.
struct Surroundings {
    bool sea = false;
    std::vector<WaveTrain> waves;
};

}  // namespace demo
