#pragma once

/// A glider of 300 kg and 12 m span, all of wings of wing.h: two on each side, of which the outer ones have
/// ailerons, a tailplane with elevator and a fin with rudder.
#include <cyclone/wing.h>
#include <cyclone/world.h>

#include <array>

#include "frames.h"
#include "random.h"

namespace cyclone_test {

class Glider {
public:
    static constexpr real MASS = 300, SPAN = 12, CHORD = 1, TAIL_SPAN = 2.4, TAIL_CHORD = 0.7, FIN_SPAN = 1.2,
                          FIN_CHORD = 0.9, LEAST_DRAG = 0.006, FUSELAGE_DRAG_AREA = 0.02, DENSITY = 1.225;

    Glider() {
        body->setMass(MASS);
        body->setInertiaTensor(diagonal(700, 1200, 550));
        body->setAcceleration(Vector3::GRAVITY);
        body->setPosition(0, 1000, 0);
        body->setVelocity(24, -1, 0);
        makeWings();
        makeTail();
        world.getForceRegistry().add(body, &fuselage);
    }

    /// −1 … 1 each: the stick pulled, the stick to starboard, the right pedal.
    void steer(real pull, real roll, real pedal) {
        tailplane.setControl(-pull);
        wings.front().setControl(roll);
        wings.back().setControl(-roll);
        fin.setControl(-pedal);
    }
    /// Stick and pedals where it glides best.
    void release() { steer(0.05, 0, 0); }

    void fly(real seconds) { run(world, static_cast<int>(seconds / STEP + 0.5)); }

    real getSpeed() const { return body->getVelocity().magnitude(); }
    /// The nose above the horizon, its heading to starboard of where it was, the starboard wing below the
    /// horizon: sines.
    real getPitch() const { return body->getDirectionInWorldSpace(Vector3::X).y; }
    real getHeading() const { return body->getDirectionInWorldSpace(Vector3::X).z; }
    real getBank() const { return -body->getDirectionInWorldSpace(Vector3::Z).y; }
    /// About the body's axes: x rolls to starboard, y yaws to port, z pitches up.
    Vector3 getRates() const { return body->getDirectionInLocalSpace(body->getRotation()); }
    bool isStalled(std::size_t wing) const { return wings[wing].isStalled(*body); }

    bool isStalledAnywhere() const { return isStalled(0) || isStalled(1) || isStalled(2) || isStalled(3); }

    cyclone::World world;
    cyclone::RigidBody *const body = world.createBody();
    std::array<cyclone::Wing, 4> wings = {makeWing(-4.5), makeWing(-1.5), makeWing(1.5), makeWing(4.5)};
    cyclone::Wing tailplane{TAIL_SPAN, TAIL_CHORD, Vector3(-4.6, 0.2, 0), nullptr};
    cyclone::Wing fin{FIN_SPAN, FIN_CHORD, Vector3(-4.6, 0.6, 0), nullptr};
    cyclone::Drag fuselage{0, 0.5 * DENSITY *FUSELAGE_DRAG_AREA};

private:
    /// A quarter of the wing, with dihedral and at an incidence of 0.05 rad.
    static cyclone::Wing makeWing(real z) {
        cyclone::Wing wing(SPAN / 4, CHORD, Vector3(0.1, 0.3, z), nullptr);
        wing.setAspectRatio(SPAN / CHORD);
        cyclone::WingSection section;
        section.zeroLiftAngle = -0.05;
        section.zeroLiftMoment = -0.07;
        section.leastDrag = LEAST_DRAG;
        wing.setSection(section);
        wing.setOrientation(Quaternion::fromAxisAngle(Vector3::X, z > 0 ? -0.06 : 0.06) *
                            Quaternion::fromAxisAngle(Vector3::Z, 0.05));
        return wing;
    }

    void makeWings() {
        wings.front().setFlap(0.25, 0.35);
        wings.back().setFlap(0.25, 0.35);
        for (cyclone::Wing &wing : wings) world.getForceRegistry().add(body, &wing);
    }

    void makeTail() {
        cyclone::WingSection section;
        section.leastDrag = LEAST_DRAG;
        tailplane.setSection(section);
        tailplane.setFlap(0.4, 0.4);
        fin.setSection(section);
        fin.setFlap(0.45, 0.5);
        fin.setOrientation(Quaternion::fromAxisAngle(Vector3::X, cyclone::REAL_PI / 2));  // lift to starboard
        world.getForceRegistry().add(body, &tailplane);
        world.getForceRegistry().add(body, &fin);
    }
};

}  // namespace cyclone_test
