// A game's program: things of its own, derived from Cyclone's, on both sides of the library's border. It
// compares what happens with what must happen, and says "falls as it should" at the end.
#include <cyclone/convert.h>
#include <cyclone/cyclone.h>
#include <cyclone/print.h>

#include <iostream>
#include <memory>
#include <stdexcept>

using namespace cyclone;

namespace {

bool allIsWell = true;

void check(bool holds, const char *what) {
    if (holds) return;
    std::cerr << "wrong: " << what << '\n';
    allIsWell = false;
}

bool isNear(real got, real want) { return real_abs(got - want) < 1e-9; }

/// A push of 3 N along X.
class Push : public ForceGenerator {
public:
    void updateForce(RigidBody *body, real) override { body->addForce(Vector3(3, 0, 0)); }
    bool actsOnItsBodyOnly() const override { return true; }
};

class Sea : public Water {
public:
    real getHeight(const Vector3 &) const override { return 100; }
};

class OneByOne : public JobSystem {
public:
    std::size_t partsDone = 0;
    void parallelFor(std::size_t count, Job &job) override {
        for (std::size_t n = 0; n < count; ++n, ++partsDone) job.run(n);
    }
};

/// Two seconds of free fall with a push: constant forces are exact in Cyclone.
void letThingsFall() {
    World world;
    OneByOne jobs;
    world.setJobSystem(&jobs);
    Gravity gravity;
    Push push;
    for (int n = 0; n < 1000; ++n) {
        RigidBody *const body = world.createBody();
        body->setMass(1.5);
        world.getForceRegistry().add(body, &gravity);
        world.getForceRegistry().add(body, &push);
    }
    for (int frame = 0; frame < 120; ++frame) {
        world.startFrame();
        world.runPhysics(1.0 / 60);
    }
    const RigidBody &last = *world.getBodies().back();
    check(isNear(last.getPosition().y, -19.62), "y = -g t^2 / 2");
    check(isNear(last.getPosition().x, 4), "x = F/m t^2 / 2");
    check(jobs.partsDone > 0, "the game's own job system is used");
    std::cout << last << '\n';
}

void letThingsFloat() {
    RigidBody body;
    Sea sea;
    Buoyancy hull(Vector3(), 1, 0.5, 0);
    hull.setWater(&sea);
    check(isNear(hull.getForce(body).y, 4905), "the game's own sea covers the hull");
}

void knowTypes() {
#ifdef __cpp_rtti
    const std::unique_ptr<ForceGenerator> forces[] = {std::make_unique<Gravity>(), std::make_unique<Push>()};
    check(dynamic_cast<Gravity *>(forces[0].get()) != nullptr, "Gravity is recognised");
    check(dynamic_cast<Gravity *>(forces[1].get()) == nullptr, "Push is no Gravity");
    check(dynamic_cast<Push *>(forces[1].get()) != nullptr, "Push is recognised");
#endif
}

void catchErrors() {
#ifdef __cpp_exceptions
    try {
        RigidBody().setMass(-1);
        check(false, "a negative mass is refused");
    } catch (const std::invalid_argument &) {
    }
#endif
}

void useTheRest() {
    struct {
        float x, y, z;
    } host = {1, 2, 3};
    const Vector3 inUnreal = AxisConvention::unreal().getPointInHost(vectorFrom(host));
    check(inUnreal == Vector3(100, 300, 200), "points arrive in Unreal");
    RigidBody ball;
    MassProperties::sphere(1, Mass(5)).applyTo(ball);
    check(isNear(ball.getInertiaTensor().data[0], 2), "a ball's inertia");
    check(CYCLONE_VERSION >= 100, "the version is known");
}

}  // namespace

int main() {
    letThingsFall();
    letThingsFloat();
    knowTypes();
    catchErrors();
    useTheRest();
    if (allIsWell) std::cout << "falls as it should\n";
    return allIsWell ? 0 : 1;
}
