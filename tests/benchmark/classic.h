#pragma once

/// What the library is compared with: the classic engine's step, written plainly. First order, one body at a
/// time, with two calls of pow and derived data computed twice a frame, as in the literature.
#include <cyclone/core.h>

#include <vector>

namespace classic {

using cyclone::Matrix3;
using cyclone::Matrix4;
using cyclone::Quaternion;
using cyclone::real;
using cyclone::Vector3;

struct Body {
    real inverseMass = 1, linearDamping = 1, angularDamping = 1;
    Vector3 position, velocity, rotation, acceleration;
    Quaternion orientation;
    Matrix3 inverseInertiaTensor = Matrix3(1, 0, 0, 0, 1, 0, 0, 0, 1);
    Matrix3 inverseInertiaTensorWorld;
    Matrix4 transform;
    Vector3 force, torque, lastFrameAcceleration;
    bool isAwake = true;

    void calculateDerivedData();
    void addForceAtBodyPoint(const Vector3 &worldForce, const Vector3 &bodyPoint);
    void clearAccumulators();
    void integrate(real duration);
};

class ForceGenerator {
public:
    virtual ~ForceGenerator() = default;
    virtual void updateForce(Body *body, real duration) = 0;
};

class Aero : public ForceGenerator {
public:
    Aero(const Matrix3 &t, const Vector3 &p, const Vector3 *w) : tensor(t), position(p), windspeed(w) {}
    void updateForce(Body *body, real duration) override;

private:
    Matrix3 tensor;
    Vector3 position;
    const Vector3 *windspeed;
};

struct World {
    struct Registration {
        Body *body;
        ForceGenerator *generator;
    };
    std::vector<Body *> bodies;
    std::vector<Registration> registrations;

    void startFrame();
    void runPhysics(real duration);
};

}  // namespace classic
