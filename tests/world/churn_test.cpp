// Bodies, generators and registrations that come and go: what is called and in which order, compared with a
// plain model that knows nothing of gaps and rings.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "random.h"

using namespace cyclone;
using cyclone_test::Random;

namespace {

constexpr real STEP = 0.01;

using Call = std::pair<const RigidBody *, const ForceGenerator *>;

/// Writes down whom it is called for, and may be tied to another body.
class Recorder : public ForceGenerator {
public:
    Recorder(std::vector<Call> &l, const RigidBody *o, bool alone) : log(l), other(o), actsAlone(alone) {}
    void updateForce(RigidBody *body, real) override { log.emplace_back(body, this); }
    const RigidBody *getOtherBody(const RigidBody *) const override { return other; }
    bool actsOnItsBodyOnly() const override { return actsAlone; }

private:
    std::vector<Call> &log;
    const RigidBody *other;
    bool actsAlone;
};

class Churn : public testing::Test {
protected:
    World world;
    std::vector<RigidBody *> bodies;  // of the world, in order
    std::vector<Call> log, registrations;
    std::deque<Recorder> recorders;
    std::vector<const RigidBody *> others;  // of each recorder
    Random random{11};

    ~Churn() override { world.getForceRegistry().clear(); }

    std::size_t below(std::size_t end) {
        return static_cast<std::size_t>(random.between(0, static_cast<real>(end)));
    }
    void create() { bodies.push_back(world.createBody()); }
    Recorder &newRecorder() {
        others.push_back(below(4) == 0 ? bodies[below(bodies.size())] : nullptr);
        recorders.emplace_back(log, others.back(), below(3) > 0);
        return recorders.back();
    }
    const RigidBody *otherOf(const ForceGenerator *generator) const {
        for (std::size_t n = 0; n < recorders.size(); ++n)
            if (&recorders[n] == generator) return others[n];
        return nullptr;
    }
    template <class Predicate>
    void forget(Predicate predicate) {
        registrations.erase(std::remove_if(registrations.begin(), registrations.end(), predicate),
                            registrations.end());
    }
    void destroy(std::size_t index) {
        RigidBody *const body = bodies[index];
        world.destroyBody(body);
        bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(index));
        forget([&](const Call &call) { return call.first == body || otherOf(call.second) == body; });
        std::replace(others.begin(), others.end(), static_cast<const RigidBody *>(body),
                     static_cast<const RigidBody *>(nullptr));
    }
    void add(Recorder &recorder) {
        RigidBody *const body = bodies[below(bodies.size())];
        world.getForceRegistry().add(body, &recorder);
        registrations.emplace_back(body, &recorder);
    }
    void expectAgreement() {
        log.clear();
        world.startFrame();
        world.runPhysics(STEP);
        ASSERT_EQ(log, registrations);
        ASSERT_EQ(world.getForceRegistry().size(), registrations.size());
        ASSERT_EQ(world.getBodies(), bodies);
    }
};

TEST_F(Churn, KeepsTheOrderOfAdding) {
    for (int n = 0; n < 300; ++n) create();
    for (int round = 0; round < 400; ++round) {
        for (int n = 0; n < 20; ++n) {
            switch (below(6)) {
                case 0:
                    if (bodies.size() > 100) destroy(below(bodies.size()));
                    break;
                case 1:
                    create();
                    break;
                case 2:
                    add(newRecorder());
                    break;
                case 3:  // the oldest of its kind
                    if (!registrations.empty()) {
                        const Call call = registrations[below(registrations.size())];
                        world.getForceRegistry().remove(const_cast<RigidBody *>(call.first),
                                                        const_cast<ForceGenerator *>(call.second));
                        registrations.erase(std::find(registrations.begin(), registrations.end(), call));
                    }
                    break;
                case 4:
                    if (!registrations.empty() && below(4) == 0) {
                        const Call call = registrations[below(registrations.size())];
                        world.getForceRegistry().remove(const_cast<ForceGenerator *>(call.second));
                        forget([&](const Call &c) { return c.second == call.second; });
                    }
                    break;
                default: {  // one more for a generator that acts already
                    Recorder &again = recorders.empty() ? newRecorder() : recorders[below(recorders.size())];
                    if (otherOf(&again) == nullptr) break;
                    add(again);
                }
            }
        }
        expectAgreement();
        if (HasFailure()) FAIL() << "round " << round;
    }
    while (!bodies.empty()) destroy(below(bodies.size()));
    expectAgreement();
    EXPECT_TRUE(registrations.empty()) << "all registrations have ended with their bodies";
}

/// Every registration is called once, each body's in its order, whatever the gaps.
TEST_F(Churn, WithThreadsEachBodysOrderIsKept) {
    class Summing : public ForceGenerator {
    public:
        explicit Summing(int n) : digit(n) {}
        void updateForce(RigidBody *body, real) override {  // so the acceleration tells the order of calls
            body->setAcceleration(body->getAcceleration().x * 3 + digit, 0, 0);
        }
        bool actsOnItsBodyOnly() const override { return true; }

    private:
        int digit;
    };
    Summing one(1), two(2);
    for (std::size_t threads : {1U, 3U}) {
        World churned;
        churned.setWorkers(threads);
        for (int n = 0; n < 6000; ++n) {
            RigidBody *const body = churned.createBody();
            churned.getForceRegistry().add(body, n % 2 == 0 ? &one : &two);
        }
        for (RigidBody *body : churned.getBodies()) churned.getForceRegistry().add(body, &two);
        const World::RigidBodies all = churned.getBodies();
        for (std::size_t n = 0; n < all.size(); n += 7) churned.destroyBody(all[n]);
        churned.getForceRegistry().updateForces(STEP);
        churned.startFrame();
        for (RigidBody *body : churned.getBodies()) body->setAcceleration(Vector3());
        churned.runPhysics(STEP);
        for (std::size_t n = 0; n < all.size(); ++n) {
            if (n % 7 == 0) continue;
            ASSERT_EQ(all[n]->getAcceleration().x, (n % 2 == 0 ? 1 : 2) * 3 + 2) << n;
        }
    }
}

TEST(Places, OfDestroyedBodiesAreUsedAgainTheOldestFirst) {
    World world;
    std::vector<RigidBody *> created;
    for (int n = 0; n < 64; ++n) created.push_back(world.createBody());
    for (std::size_t n : {5U, 60U, 0U}) world.destroyBody(created[n]);
    for (std::size_t n : {5U, 60U, 0U}) EXPECT_EQ(world.createBody(), created[n]);
}

/// Adds a force to another body than its own, and says so or does not.
class OnAnother : public ForceGenerator {
public:
    OnAnother(RigidBody *a, bool c) : another(a), conceals(c) {}
    void updateForce(RigidBody *, real) override { another->addForce(Vector3(1, 0, 0)); }
    bool actsOnItsBodyOnly() const override { return conceals; }

private:
    RigidBody *another;
    bool conceals;
};

/// While a generator that may act on any body is registered, whatever generators add to any body counts as
/// theirs: half a kick is taken back when it ends. After clear() no such generator is left.
TEST(CrossBodyGenerators, AreForgottenByClear) {
    World world;
    RigidBody *const body = world.createBody(), *const another = world.createBody();
    OnAnother open(another, false), concealing(another, true);
    const auto velocityAfterOneFrameOf = [&](ForceGenerator &generator) {
        another->setState(RigidBody::State());
        world.getForceRegistry().add(body, &generator);
        for (int n = 0; n < 2; ++n) {
            world.startFrame();
            world.runPhysics(STEP);
            world.getForceRegistry().clear();
        }
        return another->getVelocity().x;
    };
    EXPECT_NEAR(velocityAfterOneFrameOf(open), STEP / 2, 1e-15);
    EXPECT_NEAR(velocityAfterOneFrameOf(concealing), STEP, 1e-15) << "taken for the caller's: a plain kick";
}

/// Runs one frame with the world's generators and one without: how fast the body is then.
real velocityAfterAPush(World &world, const RigidBody &body) {
    world.startFrame();
    world.runPhysics(STEP);
    world.getForceRegistry().clear();
    world.startFrame();
    world.runPhysics(STEP);
    return body.getVelocity().x;
}

TEST(CrossBodyGenerators, AreNotForgottenWhenOthersEnd) {
    World world;
    RigidBody *const body = world.createBody(), *const another = world.createBody();
    OnAnother open(another, false), own(body, true);
    world.getForceRegistry().add(body, &open);
    world.getForceRegistry().add(body, &own);
    world.getForceRegistry().remove(&own);
    EXPECT_NEAR(velocityAfterAPush(world, *another), STEP / 2, 1e-15);
}

TEST(CrossBodyGenerators, ComeBackWithASnapshot) {
    World world;
    RigidBody *const body = world.createBody(), *const another = world.createBody();
    world.createForce<OnAnother>(body, another, false);
    Snapshot before;
    world.saveState(before);
    world.getForceRegistry().clear();
    world.restoreState(before);
    EXPECT_NEAR(velocityAfterAPush(world, *another), STEP / 2, 1e-15);
}

}  // namespace
