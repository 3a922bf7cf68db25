// One table of bad inputs. Each must be refused with a text that names the function, the rule and the value,
// and must leave everything as it was.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

const Matrix3 TENSOR = diagonal(-1, -2, -3);

Waves::Train train(real amplitude, real wavelength, real direction, real phase) {
    Waves::Train result;
    result.amplitude = amplitude;
    result.wavelength = wavelength;
    result.direction = direction;
    result.phase = phase;
    return result;
}

/// One of everything that has setters, none in its default state.
struct Scene {
    RigidBody body, stranger;
    Vector3 wind = Vector3(1, 2, 3);
    AnchoredSpring spring{Vector3(1, 0, 0), Vector3(4, 5, 6), 10, 1};
    AeroControl wing{TENSOR, TENSOR * 2, TENSOR * 3, Vector3(1, 0, 0), &wind};
    AngledAero sail{TENSOR, Vector3(0, 1, 0), &wind};
    Buoyancy hull{Vector3(), 1, 2, 0};
    Waves waves;
    Thruster engine{Vector3(1, 2, 2), Vector3(-1, 0, 0), 100};
    FixedStep clock;
    World world;
    RigidBody *owned = world.createBody();

    Scene() {
        body.setMass(3);
        body.setInertiaTensor(Matrix3(3, -0.5, 0.1, -0.5, 4, 0, 0.1, 0, 5));
        body.setDamping(0.9, 0.8);
        body.setPosition(1, 2, 3);
        body.setOrientation(0.5, -0.5, 0.5, 0.5);
        body.setVelocity(-1, 4, 2);
        body.setRotation(0.3, 0.2, 0.1);
        body.setAcceleration(Vector3::GRAVITY);
        body.setSleepEpsilon(0.02);
        body.addForce(Vector3(1, 2, 3));
        owned->setVelocity(1, 0, 0);
        wing.setControl(0.4);
        sail.setOrientation(Quaternion(1, 0, 1, 0));
        waves.addTrain(train(0.5, 10, 1, 2));
        waves.setTime(3);
        engine.setThrottle(0.7);
        clock.advance(0.01);
        world.addBody(&body);
        world.getForceRegistry().add(&body, &wing);
    }

    /// Whatever can be seen from outside.
    std::vector<real> look() {
        std::vector<real> seen;
        const auto see = [&](const Vector3 &v) { seen.insert(seen.end(), {v.x, v.y, v.z}); };
        for (const RigidBody *b : {&body, owned}) {
            seen.insert(seen.end(), {b->getMass(), b->getInverseMass(), b->getLinearDamping(),
                                     b->getAngularDamping(), b->getSleepEpsilon()});
            for (real entry : b->getTransform().data) seen.push_back(entry);
            for (real entry : b->getInertiaTensor().data) seen.push_back(entry);
            see(b->getVelocity());
            see(b->getRotation());
            see(b->getAngularMomentum());
            see(b->getAcceleration());
            see(b->getState().added.force);
            see(b->getState().generated.force);
            seen.push_back(b->getAwake());
        }
        see(spring.getAnchor());
        see(wing.getForce(body));
        seen.push_back(wing.getControl());
        see(sail.getForce(body));
        see(hull.getForce(body));
        seen.push_back(waves.getHeight(Vector3(1, 2, 3)));
        seen.push_back(waves.getTime());
        see(engine.getForce(body));
        seen.push_back(engine.getThrottle());
        see(engine.getDirection());
        seen.push_back(clock.getFraction());
        for (const RigidBody *b : world.getBodies()) seen.push_back(b == &body ? 1 : 2);
        seen.push_back(static_cast<real>(world.getForceRegistry().size()));
        return seen;
    }
};

struct BadCall {
    const char *function;
    const char *rule;   ///< words that the rule must contain
    const char *value;  ///< as the text must quote it; empty where there is none to quote
    std::function<void(Scene &)> call;
};

const Vector3 P(1, 2, 3);  // a good point
const Vector3 POINT_NAN(1, QUIET_NAN, 3), POINT_INF(1, 2, -PLUS_INFINITY);
const Matrix3 MATRIX_NAN(1, 0, 0, 0, QUIET_NAN, 0, 0, 0, 1);
const Matrix3 MATRIX_INF(1, 0, 0, 0, 1, 0, 0, 0, PLUS_INFINITY);
constexpr real NANQ = QUIET_NAN, INF = PLUS_INFINITY;

const BadCall MASS[] = {
    {"RigidBody::setMass", "positive", "0", [](Scene &s) { s.body.setMass(0); }},
    {"RigidBody::setMass", "positive", "-1", [](Scene &s) { s.body.setMass(-1); }},
    {"RigidBody::setMass", "finite", "nan", [](Scene &s) { s.body.setMass(NANQ); }},
    {"RigidBody::setMass", "finite", "inf", [](Scene &s) { s.body.setMass(INF); }},
    {"RigidBody::setInverseMass", "not negative", "-2", [](Scene &s) { s.body.setInverseMass(-2); }},
    {"RigidBody::setInverseMass", "finite", "nan", [](Scene &s) { s.body.setInverseMass(NANQ); }},
    {"RigidBody::setInverseMass", "finite", "inf", [](Scene &s) { s.body.setInverseMass(INF); }},
    {"RigidBody::setInertiaTensor", "positive definite", "0, 0, 0",
     [](Scene &s) { s.body.setInertiaTensor(Matrix3()); }},
    {"RigidBody::setInertiaTensor", "positive definite", "1, 0, 0, 0, 1, 0, 0, 0, 0",
     [](Scene &s) { s.body.setInertiaTensor(diagonal(1, 1, 0)); }},
    {"RigidBody::setInertiaTensor", "positive definite", "-1",
     [](Scene &s) { s.body.setInertiaTensor(diagonal(1, 1, -1)); }},
    {"RigidBody::setInertiaTensor", "positive definite", "(1, 2, 0, 2, 1, 0, 0, 0, 1)",
     [](Scene &s) { s.body.setInertiaTensor(Matrix3(1, 2, 0, 2, 1, 0, 0, 0, 1)); }},
    {"RigidBody::setInertiaTensor", "symmetric", "0.5",
     [](Scene &s) { s.body.setInertiaTensor(Matrix3(1, 0.5, 0, 0, 1, 0, 0, 0, 1)); }},
    {"RigidBody::setInertiaTensor", "symmetric", "0.001",
     [](Scene &s) { s.body.setInertiaTensor(Matrix3(1, 0, 0, 0, 1, 0, 0, 0.001, 1)); }},
    {"RigidBody::setInertiaTensor", "finite", "nan", [](Scene &s) { s.body.setInertiaTensor(MATRIX_NAN); }},
    {"RigidBody::setInertiaTensor", "finite", "inf", [](Scene &s) { s.body.setInertiaTensor(MATRIX_INF); }},
    {"RigidBody::setInverseInertiaTensor", "negative", "-1",
     [](Scene &s) { s.body.setInverseInertiaTensor(diagonal(1, -1, 1)); }},
    {"RigidBody::setInverseInertiaTensor", "negative", "(1, 2, 0, 2, 1, 0, 0, 0, 1)",
     [](Scene &s) { s.body.setInverseInertiaTensor(Matrix3(1, 2, 0, 2, 1, 0, 0, 0, 1)); }},
    {"RigidBody::setInverseInertiaTensor", "symmetric", "0.5",
     [](Scene &s) { s.body.setInverseInertiaTensor(Matrix3(1, 0, 0.5, 0, 1, 0, 0, 0, 1)); }},
    {"RigidBody::setInverseInertiaTensor", "finite", "nan",
     [](Scene &s) { s.body.setInverseInertiaTensor(MATRIX_NAN); }},
    {"RigidBody::setInverseInertiaTensor", "finite", "inf",
     [](Scene &s) { s.body.setInverseInertiaTensor(MATRIX_INF); }},
    {"Matrix3::setBlockInertiaTensor", "half sizes", "(0, 2, 3)",
     [](Scene &) { Matrix3().setBlockInertiaTensor(Vector3(0, 2, 3), 1); }},
    {"Matrix3::setBlockInertiaTensor", "half sizes", "(1, 0, 3)",
     [](Scene &) { Matrix3().setBlockInertiaTensor(Vector3(1, 0, 3), 1); }},
    {"Matrix3::setBlockInertiaTensor", "half sizes", "(1, 2, 0)",
     [](Scene &) { Matrix3().setBlockInertiaTensor(Vector3(1, 2, 0), 1); }},
    {"Matrix3::setBlockInertiaTensor", "half sizes", "(1, 2, -inf)",
     [](Scene &) { Matrix3().setBlockInertiaTensor(POINT_INF, 1); }},
    {"Matrix3::setBlockInertiaTensor", "mass", "0", [](Scene &) { Matrix3().setBlockInertiaTensor(P, 0); }},
};

const BadCall MOTION[] = {
    {"RigidBody::setDamping", "between 0 and 1", "-0.1", [](Scene &s) { s.body.setDamping(-0.1, 1); }},
    {"RigidBody::setDamping", "between 0 and 1", "1.1", [](Scene &s) { s.body.setDamping(0.5, 1.1); }},
    {"RigidBody::setDamping", "between 0 and 1", "nan", [](Scene &s) { s.body.setDamping(0.5, NANQ); }},
    {"RigidBody::setLinearDamping", "between 0 and 1", "2", [](Scene &s) { s.body.setLinearDamping(2); }},
    {"RigidBody::setLinearDamping", "between 0 and 1", "nan",
     [](Scene &s) { s.body.setLinearDamping(NANQ); }},
    {"RigidBody::setAngularDamping", "between 0 and 1", "-1", [](Scene &s) { s.body.setAngularDamping(-1); }},
    {"RigidBody::setPosition", "finite", "(1, nan, 3)", [](Scene &s) { s.body.setPosition(POINT_NAN); }},
    {"RigidBody::setPosition", "finite", "(inf, 0, 0)", [](Scene &s) { s.body.setPosition(INF, 0, 0); }},
    {"RigidBody::setOrientation", "not zero", "(0, 0, 0, 0)",
     [](Scene &s) { s.body.setOrientation(0, 0, 0, 0); }},
    {"RigidBody::setOrientation", "finite", "(nan, 0, 0, 0)",
     [](Scene &s) { s.body.setOrientation(Quaternion(NANQ, 0, 0, 0)); }},
    {"RigidBody::setOrientation", "finite", "(1, 0, inf, 0)",
     [](Scene &s) { s.body.setOrientation(1, 0, INF, 0); }},
    {"RigidBody::setVelocity", "finite", "(1, nan, 3)", [](Scene &s) { s.body.setVelocity(POINT_NAN); }},
    {"RigidBody::setVelocity", "finite", "(1, 2, -inf)", [](Scene &s) { s.body.setVelocity(1, 2, -INF); }},
    {"RigidBody::setRotation", "finite", "(1, nan, 3)", [](Scene &s) { s.body.setRotation(POINT_NAN); }},
    {"RigidBody::setRotation", "finite", "(0, inf, 0)", [](Scene &s) { s.body.setRotation(0, INF, 0); }},
    {"RigidBody::addImpulse", "finite", "(1, nan, 3)", [](Scene &s) { s.body.addImpulse(POINT_NAN); }},
    {"RigidBody::addImpulseAtPoint", "point must be finite", "-inf",
     [](Scene &s) { s.body.addImpulseAtPoint(P, POINT_INF); }},
    {"RigidBody::addVelocity", "finite", "nan", [](Scene &s) { s.body.addVelocity(POINT_NAN); }},
    {"RigidBody::addRotation", "finite", "-inf", [](Scene &s) { s.body.addRotation(POINT_INF); }},
    {"RigidBody::setAcceleration", "finite", "(1, 2, -inf)",
     [](Scene &s) { s.body.setAcceleration(POINT_INF); }},
    {"RigidBody::setAcceleration", "finite", "(0, nan, 0)",
     [](Scene &s) { s.body.setAcceleration(0, NANQ, 0); }},
    {"RigidBody::setSleepEpsilon", "not negative", "-1", [](Scene &s) { s.body.setSleepEpsilon(-1); }},
    {"RigidBody::setSleepEpsilon", "finite", "nan", [](Scene &s) { s.body.setSleepEpsilon(NANQ); }},
    {"RigidBody::setSleepEpsilon", "finite", "inf", [](Scene &s) { s.body.setSleepEpsilon(INF); }},
    {"RigidBody::integrate", "not negative", "-0.1", [](Scene &s) { s.body.integrate(-0.1); }},
    {"RigidBody::integrate", "finite", "nan", [](Scene &s) { s.body.integrate(NANQ); }},
    {"RigidBody::integrate", "finite", "inf", [](Scene &s) { s.body.integrate(INF); }},
    {"RigidBody::integrate", "finite", "nan",
     [](Scene &s) { RigidBody::integrate(s.world.getBodies().data(), 2, NANQ); }},
    {"RigidBody::setState", "", "",
     [](Scene &s) {
         RigidBody::State state = s.body.getState();
         state.velocity.y = NANQ;
         s.body.setState(state);
     }},
    {"RigidBody::setState", "", "",
     [](Scene &s) {
         RigidBody::State state = s.body.getState();
         state.orientation = Quaternion(0, 0, 0, 0);
         s.body.setState(state);
     }},
    {"RigidBody::setState", "", "",
     [](Scene &s) {
         RigidBody::State state = s.body.getState();
         state.inverseMass = -1;
         s.body.setState(state);
     }},
    {"RigidBody::getInertiaTensor", "locked", "(1, 0, 1)",
     [](Scene &) {
         RigidBody locked;
         locked.setInverseInertiaTensor(diagonal(1, 0, 1));
         locked.getInertiaTensor();
     }},
};

const BadCall SIMPLE_FORCES[] = {
    {"Gravity::Gravity", "finite", "(1, nan, 3)", [](Scene &) { Gravity g(POINT_NAN); }},
    {"Drag::Drag", "not negative", "-1", [](Scene &) { Drag d(-1, 0); }},
    {"Drag::Drag", "not negative", "-2", [](Scene &) { Drag d(0, -2); }},
    {"Drag::Drag", "finite", "nan", [](Scene &) { Drag d(NANQ, 0); }},
    {"Drag::Drag", "finite", "inf", [](Scene &) { Drag d(0, INF); }},
    {"Spring::Spring", "finite", "(1, nan, 3)", [](Scene &s) { Spring f(POINT_NAN, &s.body, P, 1, 1); }},
    {"Spring::Spring", "null", "", [](Scene &) { Spring f(P, nullptr, P, 1, 1); }},
    {"Spring::Spring", "finite", "(1, 2, -inf)", [](Scene &s) { Spring f(P, &s.body, POINT_INF, 1, 1); }},
    {"Spring::Spring", "not negative", "-1", [](Scene &s) { Spring f(P, &s.body, P, -1, 1); }},
    {"Spring::Spring", "not negative", "-3", [](Scene &s) { Spring f(P, &s.body, P, 1, -3); }},
    {"Spring::Spring", "finite", "nan", [](Scene &s) { Spring f(P, &s.body, P, NANQ, 1); }},
    {"Spring::Spring", "finite", "inf", [](Scene &s) { Spring f(P, &s.body, P, 1, INF); }},
    {"Spring::Spring", "body must not be null", "", [](Scene &s) { Spring f(nullptr, P, &s.body, P, 1, 1); }},
    {"Spring::Spring", "different", "", [](Scene &s) { Spring f(&s.body, P, &s.body, P, 1, 1); }},
    {"Bungee::Bungee", "body must not be null", "", [](Scene &s) { Bungee f(nullptr, P, &s.body, P, 1, 1); }},
    {"ElasticForce::setSpringConstant", "not negative", "-1",
     [](Scene &s) { s.spring.setSpringConstant(-1); }},
    {"ElasticForce::setRestLength", "not negative", "-1", [](Scene &s) { s.spring.setRestLength(-1); }},
    {"ElasticForce::setDamping", "finite", "nan", [](Scene &s) { s.spring.setDamping(NANQ); }},
    {"Bungee::Bungee", "null", "", [](Scene &) { Bungee f(P, nullptr, P, 1, 1); }},
    {"Bungee::Bungee", "not negative", "-1", [](Scene &s) { Bungee f(P, &s.body, P, -1, 1); }},
    {"AnchoredSpring::AnchoredSpring", "finite", "nan",
     [](Scene &) { AnchoredSpring f(POINT_NAN, P, 1, 1); }},
    {"AnchoredSpring::AnchoredSpring", "finite", "inf",
     [](Scene &) { AnchoredSpring f(P, POINT_INF, 1, 1); }},
    {"AnchoredSpring::AnchoredSpring", "not negative", "-1", [](Scene &) { AnchoredSpring f(P, P, -1, 1); }},
    {"AnchoredSpring::AnchoredSpring", "not negative", "-2", [](Scene &) { AnchoredSpring f(P, P, 1, -2); }},
    {"AnchoredSpring::AnchoredSpring", "finite", "nan", [](Scene &) { AnchoredSpring f(P, P, 1, NANQ); }},
    {"AnchoredSpring::setAnchor", "finite", "(1, nan, 3)", [](Scene &s) { s.spring.setAnchor(POINT_NAN); }},
};

// A surface that is a kind of Aero, and a propeller that is a kind of Thruster, may name the function of the
// latter, whose rule it is.
const BadCall SURFACES[] = {
    {"Aero::Aero", "finite", "nan", [](Scene &) { Aero a(MATRIX_NAN, P, nullptr); }},
    {"Aero::Aero", "finite", "inf", [](Scene &) { Aero a(MATRIX_INF, P, nullptr); }},
    {"Aero::Aero", "finite", "(1, nan, 3)", [](Scene &) { Aero a(TENSOR, POINT_NAN, nullptr); }},
    {"AeroControl::AeroControl", "finite", "nan",
     [](Scene &) { AeroControl a(MATRIX_NAN, TENSOR, TENSOR, P, nullptr); }},
    {"AeroControl::AeroControl", "finite", "nan",
     [](Scene &) { AeroControl a(TENSOR, MATRIX_NAN, TENSOR, P, nullptr); }},
    {"AeroControl::AeroControl", "finite", "inf",
     [](Scene &) { AeroControl a(TENSOR, TENSOR, MATRIX_INF, P, nullptr); }},
    {"AeroControl::AeroControl", "finite", "-inf",
     [](Scene &) { AeroControl a(TENSOR, TENSOR, TENSOR, POINT_INF, nullptr); }},
    {"AeroControl::setControl", "finite", "nan", [](Scene &s) { s.wing.setControl(NANQ); }},
    {"AeroControl::setControl", "finite", "inf", [](Scene &s) { s.wing.setControl(INF); }},
    {"AngledAero::AngledAero", "finite", "nan", [](Scene &) { AngledAero a(MATRIX_NAN, P, nullptr); }},
    {"AngledAero::AngledAero", "finite", "-inf", [](Scene &) { AngledAero a(TENSOR, POINT_INF, nullptr); }},
    {"AngledAero::setOrientation", "not zero", "(0, 0, 0, 0)",
     [](Scene &s) { s.sail.setOrientation(Quaternion(0, 0, 0, 0)); }},
    {"AngledAero::setOrientation", "finite", "(1, nan, 0, 0)",
     [](Scene &s) { s.sail.setOrientation(Quaternion(1, NANQ, 0, 0)); }},
    {"AngledAero::setOrientation", "finite", "(1, 0, 0, inf)",
     [](Scene &s) { s.sail.setOrientation(Quaternion(1, 0, 0, INF)); }},
    {"Aero::setWater", "fullDepth must be positive", "0", [](Scene &s) { s.sail.setWater(&s.waves, 0); }},
    {"Aero::setWater", "fullDepth must be positive", "nan",
     [](Scene &s) { s.sail.setWater(&s.waves, NANQ); }},
    {"Aero::setWater", "fullDepth must be positive", "-1", [](Scene &s) { s.sail.setWater(nullptr, -1); }},
};

const BadCall WATER[] = {
    {"Buoyancy::Buoyancy", "finite", "(1, nan, 3)", [](Scene &) { Buoyancy b(POINT_NAN, 1, 1, 0); }},
    {"Buoyancy::Buoyancy", "positive", "0", [](Scene &) { Buoyancy b(P, 0, 1, 0); }},
    {"Buoyancy::Buoyancy", "positive", "-1", [](Scene &) { Buoyancy b(P, -1, 1, 0); }},
    {"Buoyancy::Buoyancy", "finite", "nan", [](Scene &) { Buoyancy b(P, NANQ, 1, 0); }},
    {"Buoyancy::Buoyancy", "finite", "inf", [](Scene &) { Buoyancy b(P, INF, 1, 0); }},
    {"Buoyancy::Buoyancy", "volume must be positive", "0", [](Scene &) { Buoyancy b(P, 1, 0, 0); }},
    {"Buoyancy::Buoyancy", "volume must be positive", "-1", [](Scene &) { Buoyancy b(P, 1, -1, 0); }},
    {"Buoyancy::Buoyancy", "height must be finite", "nan", [](Scene &) { Buoyancy b(P, 1, 1, NANQ); }},
    {"Buoyancy::Buoyancy", "height must be finite", "inf", [](Scene &) { Buoyancy b(P, 1, 1, INF); }},
    {"Buoyancy::Buoyancy", "density must be positive", "0", [](Scene &) { Buoyancy b(P, 1, 1, 0, 0); }},
    {"Buoyancy::Buoyancy", "density must be positive", "-1", [](Scene &) { Buoyancy b(P, 1, 1, 0, -1); }},
    {"Buoyancy::Buoyancy", "gravity must be positive", "-9.81",
     [](Scene &) { Buoyancy b(P, 1, 1, 0, 1000, -9.81); }},
    {"Buoyancy::Buoyancy", "gravity must be positive", "nan",
     [](Scene &) { Buoyancy b(P, 1, 1, 0, 1000, NANQ); }},
    {"Waves::Waves", "finite", "nan", [](Scene &) { Waves w(NANQ); }},
    {"Waves::Waves", "positive", "0", [](Scene &) { Waves w(0, 0); }},
    {"Waves::Waves", "positive", "inf", [](Scene &) { Waves w(0, INF); }},
    {"Waves::addTrain", "amplitude", "-1", [](Scene &s) { s.waves.addTrain(train(-1, 1, 0, 0)); }},
    {"Waves::addTrain", "amplitude", "nan", [](Scene &s) { s.waves.addTrain(train(NANQ, 1, 0, 0)); }},
    {"Waves::addTrain", "wavelength", "0", [](Scene &s) { s.waves.addTrain(train(1, 0, 0, 0)); }},
    {"Waves::addTrain", "wavelength", "-1", [](Scene &s) { s.waves.addTrain(train(1, -1, 0, 0)); }},
    {"Waves::addTrain", "wavelength", "inf", [](Scene &s) { s.waves.addTrain(train(1, INF, 0, 0)); }},
    {"Waves::addTrain", "direction", "nan", [](Scene &s) { s.waves.addTrain(train(1, 1, NANQ, 0)); }},
    {"Waves::addTrain", "phase", "inf", [](Scene &s) { s.waves.addTrain(train(1, 1, 0, INF)); }},
    {"Waves::setTime", "finite", "nan", [](Scene &s) { s.waves.setTime(NANQ); }},
    {"HullDrag::HullDrag", "not be null", "", [](Scene &) { HullDrag d(nullptr, P, P, P); }},
    {"HullDrag::HullDrag", "position", "(1, nan, 3)", [](Scene &s) { HullDrag d(&s.hull, POINT_NAN, P, P); }},
    {"HullDrag::HullDrag", "linear must be", "-1",
     [](Scene &s) { HullDrag d(&s.hull, P, Vector3(0, -1, 0), P); }},
    {"HullDrag::HullDrag", "linear must be", "nan", [](Scene &s) { HullDrag d(&s.hull, P, POINT_NAN, P); }},
    {"HullDrag::HullDrag", "quadratic must be", "-inf",
     [](Scene &s) { HullDrag d(&s.hull, P, P, POINT_INF); }},
};

const BadCall PROPULSION[] = {
    {"Thruster::", "not zero", "(0, 0, 0)", [](Scene &) { Thruster t(Vector3(), P, 1); }},
    {"Thruster::", "finite", "(1, nan, 3)", [](Scene &) { Thruster t(POINT_NAN, P, 1); }},
    {"Thruster::Thruster", "position", "(1, nan, 3)", [](Scene &) { Thruster t(P, POINT_NAN, 1); }},
    {"Thruster::Thruster", "not negative", "-1", [](Scene &) { Thruster t(P, P, -1); }},
    {"Thruster::Thruster", "finite", "inf", [](Scene &) { Thruster t(P, P, INF); }},
    {"Thruster::setThrottle", "finite", "nan", [](Scene &s) { s.engine.setThrottle(NANQ); }},
    {"Thruster::setThrottle", "finite", "-inf", [](Scene &s) { s.engine.setThrottle(-INF); }},
    {"Thruster::setDirection", "not zero", "(0, 0, 0)", [](Scene &s) { s.engine.setDirection(Vector3()); }},
    {"Thruster::setDirection", "finite", "(1, 2, -inf)", [](Scene &s) { s.engine.setDirection(POINT_INF); }},
    {"Thruster::setWater", "radius must be positive", "0", [](Scene &s) { s.engine.setWater(&s.waves, 0); }},
    {"Thruster::setWater", "radius must be positive", "inf",
     [](Scene &s) { s.engine.setWater(&s.waves, INF); }},
    {"Propeller::Propeller", "positive", "0", [](Scene &) { Propeller p(P, P, 1, 0, nullptr); }},
    {"Propeller::Propeller", "positive", "-1", [](Scene &) { Propeller p(P, P, 1, -1, nullptr); }},
    {"Propeller::Propeller", "finite", "inf", [](Scene &) { Propeller p(P, P, 1, INF, nullptr); }},
    {"Propeller::Propeller", "not negative", "-5", [](Scene &) { Propeller p(P, P, -5, 1, nullptr); }},
};

const BadCall WORLD[] = {
    {"ForceRegistry::add", "body must not be null", "",
     [](Scene &s) { s.world.getForceRegistry().add(nullptr, &s.wing); }},
    {"ForceRegistry::add", "generator must not be null", "",
     [](Scene &s) { s.world.getForceRegistry().add(&s.body, nullptr); }},
    {"ForceRegistry::remove", "body must not be null", "",
     [](Scene &s) { s.world.getForceRegistry().remove(nullptr, &s.wing); }},
    {"ForceRegistry::remove", "generator must not be null", "",
     [](Scene &s) { s.world.getForceRegistry().remove(&s.body, nullptr); }},
    {"ForceRegistry::remove", "body must not be null", "",
     [](Scene &s) { s.world.getForceRegistry().remove(static_cast<RigidBody *>(nullptr)); }},
    {"ForceRegistry::updateForces", "not negative", "-1",
     [](Scene &s) { s.world.getForceRegistry().updateForces(-1); }},
    {"ForceRegistry::updateForces", "finite", "nan",
     [](Scene &s) { s.world.getForceRegistry().updateForces(NANQ); }},
    {"World::addBody", "null", "", [](Scene &s) { s.world.addBody(nullptr); }},
    {"World::addBody", "already", "", [](Scene &s) { s.world.addBody(&s.body); }},
    {"World::addBody", "already", "", [](Scene &s) { s.world.addBody(s.owned); }},
    {"World::removeBody", "null", "", [](Scene &s) { s.world.removeBody(nullptr); }},
    {"World::removeBody", "destroyBody", "", [](Scene &s) { s.world.removeBody(s.owned); }},
    {"World::destroyBody", "null", "", [](Scene &s) { s.world.destroyBody(nullptr); }},
    {"World::destroyBody", "created by this world", "", [](Scene &s) { s.world.destroyBody(&s.body); }},
    {"World::destroyBody", "created by this world", "", [](Scene &s) { s.world.destroyBody(&s.stranger); }},
    {"World::destroyBody", "created by this world", "",
     [](Scene &s) {
         World other;
         s.world.destroyBody(other.createBody());
     }},
    {"World::createForce", "body must not be null", "",
     [](Scene &s) { s.world.createForce<Drag>(nullptr, 1, 1); }},
    {"World::createForce", "in the world", "",
     [](Scene &s) { s.world.createForce<Drag>(&s.stranger, 1, 1); }},
    {"World::createSpring", "in the world", "",
     [](Scene &s) { s.world.createSpring(s.owned, P, &s.stranger, P, 1, 1); }},
    {"World::destroyForce", "created by this world", "", [](Scene &s) { s.world.destroyForce(s.wing); }},
    {"ForceRegistry::remove", "generator must not be null", "",
     [](Scene &s) { s.world.getForceRegistry().remove(static_cast<ForceGenerator *>(nullptr)); }},
    {"World::integrate", "not negative", "-1", [](Scene &s) { s.world.integrate(-1); }},
    {"World::integrate", "finite", "nan", [](Scene &s) { s.world.integrate(NANQ); }},
    {"World::runPhysics", "not negative", "-0.5", [](Scene &s) { s.world.runPhysics(-0.5); }},
    {"World::runPhysics", "finite", "inf", [](Scene &s) { s.world.runPhysics(INF); }},
    {"Workers::Workers", "between 1 and 256", "0", [](Scene &) { Workers w(0); }},
    {"Workers::Workers", "between 1 and 256", "257", [](Scene &) { Workers w(257); }},
    {"World::setWorkers", "at most 256", "1000000", [](Scene &s) { s.world.setWorkers(1000000); }},
    {"FixedStep::FixedStep", "positive", "0", [](Scene &) { FixedStep f(0); }},
    {"FixedStep::FixedStep", "longest time", "nan", [](Scene &) { FixedStep f(0.01, NANQ); }},
    {"FixedStep::advance", "not negative", "-1", [](Scene &s) { s.clock.advance(-1); }},
    {"FixedStep::advance", "", "nan", [](Scene &s) { s.clock.advance(NANQ); }},
};

class BadInput : public testing::TestWithParam<BadCall> {};

std::string refusalText(const BadCall &bad, Scene &scene) {
    try {
        bad.call(scene);
    } catch (const std::invalid_argument &error) {
        return error.what();
    }
    return "not refused";
}

TEST_P(BadInput, IsRefusedAndChangesNothing) {
    const BadCall &bad = GetParam();
    Scene scene;
    const std::vector<real> before = scene.look();
    const std::string text = refusalText(bad, scene);

    EXPECT_EQ(text.rfind(bad.function, 0), 0U) << text;
    const std::size_t ruleAt = text.find(": "), valueAt = text.rfind(", not ");
    ASSERT_NE(ruleAt, std::string::npos) << text;
    EXPECT_NE(text.find(bad.rule, ruleAt), std::string::npos) << text;
    if (*bad.value != '\0') {
        ASSERT_NE(valueAt, std::string::npos) << text;
        EXPECT_NE(text.find(bad.value, valueAt + 6), std::string::npos) << text;
    }
    EXPECT_EQ(scene.look(), before) << text;
}

void PrintTo(const BadCall &bad, std::ostream *out) { *out << bad.function << " " << bad.value; }

INSTANTIATE_TEST_SUITE_P(Mass, BadInput, testing::ValuesIn(MASS));
INSTANTIATE_TEST_SUITE_P(Motion, BadInput, testing::ValuesIn(MOTION));
INSTANTIATE_TEST_SUITE_P(SimpleForces, BadInput, testing::ValuesIn(SIMPLE_FORCES));
INSTANTIATE_TEST_SUITE_P(Surfaces, BadInput, testing::ValuesIn(SURFACES));
INSTANTIATE_TEST_SUITE_P(Water, BadInput, testing::ValuesIn(WATER));
INSTANTIATE_TEST_SUITE_P(Propulsion, BadInput, testing::ValuesIn(PROPULSION));
INSTANTIATE_TEST_SUITE_P(World, BadInput, testing::ValuesIn(WORLD));

TEST(Refusal, QuotesNumbers) {
    try {
        detail::reject("Thing::set", "the numbers must be good", {-1, 0.5, PLUS_INFINITY});
    } catch (const std::invalid_argument &error) {
        EXPECT_STREQ(error.what(), "Thing::set: the numbers must be good, not (-1, 0.5, inf)");
    }
    try {
        detail::reject("Thing::set", "the number must be good", {-1});
    } catch (const std::invalid_argument &error) {
        EXPECT_STREQ(error.what(), "Thing::set: the number must be good, not -1");
    }
    EXPECT_THROW(detail::require(false, "f", "r"), std::invalid_argument);
    EXPECT_NO_THROW(detail::require(true, "f", "r"));
    int number = 0;
    EXPECT_EQ(detail::requireNonNull(&number, "f", "r"), &number);
}

}  // namespace
