#pragma once

/// What can be drawn. The terminal's canvas and the page's viewer show the same scene.
#include <cyclone/body.h>
#include <cyclone/buoyancy.h>

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

/// A vehicle, a mark afloat, a pod: parts that move together. parts[0] is the body itself, +X forward.
struct Body {
    std::vector<Part> parts;
    bool leavesTrail = false;
    bool isGhost = false;  ///< one sees through it, and it casts no shadow
};

/// Where a part is: its frame to world, as a body's position (m) and orientation.
struct Pose {
    Vector3 position;
    Quaternion orientation;
};

/// Where a part is put that is not to be seen: under the ground.
extern const Pose NOWHERE;

/// Of a part that turns about a point of a body: a flap on its hinge.
Pose poseOn(const cyclone::RigidBody &body, const Vector3 &bodyPoint, const Vector3 &bodyAxis, real angle);

/// A force or a wind: drawn from `tail` along `vector`, both in world metres.
struct Arrow {
    std::string name;
    Vector3 tail, vector;
    Colour colour;
};

/// What the bodies move over: land is the plane y = 0, the sea that plane with waves; in space there is
/// nothing, and it is dark.
enum class Terrain { LAND, SEA, SPACE };

struct Surroundings {
    Terrain terrain = Terrain::LAND;
    std::vector<cyclone::Waves::Train> waves;  ///< of the sea
};

/// The train's ω on deep water, rad/s: ω² = g·k (see cyclone::Waves).
real frequencyOf(const cyclone::Waves::Train &train);

/// CHASE: from behind. SIDE: from port and a little from behind. SPECTATOR: from one place. PLANE: along −Z
/// from far off, as flat as a map of the plane z = 0, with the trails.
enum class Viewpoint { CHASE, SIDE, SPECTATOR, PLANE };

/// From where one can look at bodies[0].
struct CameraSettings {
    std::vector<Viewpoint> viewpoints{Viewpoint::CHASE, Viewpoint::SIDE, Viewpoint::SPECTATOR};
    Vector3 spectator{0, 1.7, 20};  ///< m
    bool spectatorFollows = false;  ///< along the ground, as from another boat, and never lower than the body
    real distance = 6;              ///< m, of the other viewpoints at zoom 1
    real height = 0;                ///< m above the body's origin: what the cameras aim at
    real windHeight = 1;            ///< m above the body's origin: where the wind is shown
};

/// What stays the same throughout a run.
struct Scene {
    Surroundings surroundings;
    std::vector<Body> bodies;    ///< the cameras follow bodies[0]
    std::vector<Part> fixtures;  ///< what never moves, in world coordinates: hoops, walls
    std::vector<Part> paint;     ///< flat marks on the land in world coordinates, the later upon the earlier
    real newtonsPerMetre = 0;    ///< the scale of the force arrows; 0: not told
    CameraSettings cameras;
};

/// Of all bodies together.
std::size_t countParts(const Scene &scene);

/// A scene at one moment.
struct Frame {
    real time = 0;              ///< s
    std::vector<Pose> poses;    ///< one for each part of each body, in their order
    std::vector<Arrow> arrows;  ///< in every frame the same arrows, in the same order
    Vector3 windspeed;          ///< m/s, towards where the wind comes from
    bool cut = false;  ///< put here, not moved here: nothing is drawn between the last frame and this one
};

/// Something that has happened, worth telling and jumping to: "touched down", "tacked".
struct Event {
    real time = 0;  ///< s
    std::string text;
};

/// What the two frames' moments make together, `share` of the way from a to b; b as it is if it is a cut.
Frame interpolated(const Frame &a, const Frame &b, real share);

/// a where share is 0, b where it is 1.
Vector3 mix(const Vector3 &a, const Vector3 &b, real share);

}  // namespace demo
