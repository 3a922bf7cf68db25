// The force registry: who is called, when and in what order, also while registrations change.
#include <cyclone/world.h>
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

constexpr real STEP = 0.01;

/// Does what it is told to.
class Scripted : public ForceGenerator {
public:
    explicit Scripted(std::function<void(RigidBody *)> what) : act(std::move(what)) {}
    void updateForce(RigidBody *body, real) override { act(body); }

private:
    std::function<void(RigidBody *)> act;
};

/// Writes its name down when it is called.
class Named : public ForceGenerator {
public:
    Named(char n, std::string &l) : name(n), log(l) {}
    void updateForce(RigidBody *, real) override { log += name; }

private:
    char name;
    std::string &log;
};

/// A constant push along X.
class Push : public ForceGenerator {
public:
    explicit Push(real n) : newtons(n) {}
    void updateForce(RigidBody *body, real) override { body->addForce(Vector3(newtons, 0, 0)); }

private:
    real newtons;
};

struct Log : testing::Test {
    std::string log;
    Named a{'a', log}, b{'b', log}, c{'c', log};
    RigidBody one, two;
    ForceRegistry registry;

    std::string calls() {
        log.clear();
        registry.updateForces(STEP);
        return log;
    }
};

using RegistryCalls = Log;

TEST_F(RegistryCalls, ComeInTheOrderOfAdding) {
    EXPECT_EQ(calls(), "");
    registry.add(&one, &b);
    registry.add(&two, &a);
    registry.add(&one, &c);
    registry.add(&two, &b);
    EXPECT_EQ(calls(), "bacb");
    EXPECT_EQ(registry.size(), 4U);
}

TEST_F(RegistryCalls, AddedTwiceItActsTwiceAndIsRemovedOnce) {
    registry.add(&one, &a);
    registry.add(&one, &b);
    registry.add(&one, &a);
    EXPECT_EQ(calls(), "aba");
    registry.remove(&one, &a);  // the oldest
    EXPECT_EQ(calls(), "ba");
    registry.remove(&one, &a);
    registry.remove(&one, &a);
    EXPECT_EQ(calls(), "b");
}

TEST_F(RegistryCalls, RemoveLooksAtBothBodyAndGenerator) {
    registry.add(&one, &a);
    registry.add(&two, &a);
    registry.remove(&one, &b);
    registry.remove(&two, &b);
    EXPECT_EQ(registry.size(), 2U);
    registry.remove(&two, &a);
    registry.add(&two, &b);
    EXPECT_EQ(calls(), "ab");
    registry.remove(&one);
    EXPECT_EQ(calls(), "b");
    registry.remove(&one);
    registry.clear();
    EXPECT_EQ(calls(), "");
    EXPECT_EQ(registry.size(), 0U);
    registry.add(&one, &c);
    EXPECT_EQ(calls(), "c");
}

TEST_F(RegistryCalls, WhatAGeneratorAddsIsCalledFromTheNextTimeOn) {
    Scripted adder([this](RigidBody *body) {
        registry.add(body, &c);
        log += '+';
    });
    registry.add(&one, &a);
    registry.add(&one, &adder);
    registry.add(&two, &b);
    EXPECT_EQ(calls(), "a+b");
    EXPECT_EQ(calls(), "a+bc");
    EXPECT_EQ(calls(), "a+bcc");
    EXPECT_EQ(registry.size(), 6U);
}

TEST_F(RegistryCalls, ManyMayBeAddedDuringACall) {
    bool first = true;
    Scripted adder([&](RigidBody *body) {
        for (int n = 0; first && n < 1000; ++n) registry.add(body, &c);
        first = false;
    });
    registry.add(&one, &adder);
    registry.add(&two, &a);
    EXPECT_EQ(calls(), "a");
    EXPECT_EQ(calls(), "a" + std::string(1000, 'c'));
}

TEST_F(RegistryCalls, WhatAGeneratorRemovesIsNotCalledAnyMore) {
    Scripted remover([this](RigidBody *) {
        registry.remove(&one, &a);
        registry.remove(&two, &b);
        EXPECT_EQ(registry.size(), 2U);
    });
    registry.add(&one, &a);  // called before it is removed
    registry.add(&one, &remover);
    registry.add(&two, &b);  // removed before it is called
    registry.add(&two, &c);
    EXPECT_EQ(calls(), "ac");
    EXPECT_EQ(calls(), "c");
    EXPECT_EQ(registry.size(), 2U);
}

TEST_F(RegistryCalls, AGeneratorMayRemoveItselfAndBeAddedAgain) {
    Scripted *self = nullptr;
    Scripted once([&](RigidBody *body) {
        log += 'x';
        registry.remove(body, self);
    });
    self = &once;
    registry.add(&one, &once);
    registry.add(&one, &a);
    EXPECT_EQ(calls(), "xa");
    EXPECT_EQ(calls(), "a");
    registry.add(&one, &once);
    EXPECT_EQ(calls(), "ax");
    EXPECT_EQ(calls(), "a");

    Scripted renewed([&](RigidBody *body) {
        log += 'r';
        registry.remove(body, self);
        registry.add(body, self);
    });
    self = &renewed;
    registry.add(&one, &renewed);
    registry.add(&two, &b);
    EXPECT_EQ(calls(), "arb");
    EXPECT_EQ(calls(), "abr");
    EXPECT_EQ(calls(), "abr");
    EXPECT_EQ(registry.size(), 3U);
}

TEST_F(RegistryCalls, UpdatingAndClearingFromAGeneratorAreRefused) {
    Scripted nested([this](RigidBody *) { registry.updateForces(STEP); });
    Scripted clearing([this](RigidBody *) { registry.clear(); });
    for (Scripted *bad : {&nested, &clearing}) {
        registry.add(&one, &a);
        registry.add(&one, bad);
        registry.add(&one, &b);
        EXPECT_THROW(registry.updateForces(STEP), std::invalid_argument);
        EXPECT_EQ(registry.size(), 3U);
        registry.remove(&one, bad);
        EXPECT_EQ(calls(), "ab");
        registry.clear();
    }
}

TEST_F(RegistryCalls, AnExceptionLeavesTheRegistryUsable) {
    bool fails = true;
    Scripted failing([&](RigidBody *body) {
        registry.remove(body, &a);
        registry.add(body, &c);
        if (fails) throw std::runtime_error("no fuel");
    });
    registry.add(&one, &a);
    registry.add(&one, &failing);
    registry.add(&one, &b);
    EXPECT_THROW(registry.updateForces(STEP), std::runtime_error);
    EXPECT_EQ(log, "a");
    EXPECT_EQ(registry.size(), 3U);
    fails = false;
    EXPECT_EQ(calls(), "bc");
}

// ---- With the step: every call counts F·h in the end, and is felt half a step early.

/// Runs a body of 1 kg, from rest, under a constant 1 N and whatever `change` does before and during frames.
struct Frames {
    World world;
    RigidBody *body = world.createBody();
    Push one{1}, extra{10};
    ForceRegistry &registry = world.getForceRegistry();

    Frames() { registry.add(body, &one); }
    real run(int frames) {
        for (int n = 0; n < frames; ++n) {
            world.startFrame();
            world.runPhysics(STEP);
        }
        return body->getVelocity().x;
    }
};

TEST(RegistryAndStep, ForcesCountForTheFramesInWhichTheyAreCalled) {
    Frames frames;
    EXPECT_NEAR(frames.run(5), 5 * STEP, 1e-15);
    frames.registry.add(frames.body, &frames.extra);
    EXPECT_NEAR(frames.run(3), (8 + 30 + 5) * STEP, 1e-14);
    frames.registry.remove(frames.body, &frames.extra);
    EXPECT_NEAR(frames.run(4), (12 + 30) * STEP, 1e-14);
    frames.registry.clear();
    EXPECT_NEAR(frames.run(2), (12 + 30 - 0.5) * STEP, 1e-14);
    frames.registry.add(frames.body, &frames.one);
    EXPECT_NEAR(frames.run(2), (14 + 30) * STEP, 1e-14);
}

TEST(RegistryAndStep, AlsoWhenAGeneratorAddsOne) {
    Frames frames;
    int calls = 0;
    Scripted adder([&](RigidBody *body) {
        if (++calls == 4) frames.registry.add(body, &frames.extra);  // called in frames 5, 6 and 7
    });
    frames.registry.add(frames.body, &adder);
    EXPECT_NEAR(frames.run(7), (7 + 30 + 5) * STEP, 1e-14);
}

TEST(RegistryAndStep, AlsoWhenAGeneratorRemovesAnother) {
    Frames frames;
    int calls = 0;
    Scripted remover([&](RigidBody *body) {
        if (++calls == 4) frames.registry.remove(body, &frames.extra);  // called in frames 1 to 4
    });
    frames.registry.add(frames.body, &frames.extra);
    frames.registry.add(frames.body, &remover);
    EXPECT_NEAR(frames.run(9), (9 + 40 - 5) * STEP, 1e-14) << "the first call opens with half a kick";
}

TEST(RegistryAndStep, AlsoWhenARocketBurnsOutAndRemovesItself) {
    Frames frames;
    int calls = 0;
    Scripted *self = nullptr;
    Scripted rocket([&](RigidBody *body) {
        body->addForce(Vector3(10, 0, 0));
        if (++calls == 3) frames.registry.remove(body, self);
    });
    self = &rocket;
    frames.registry.add(frames.body, &rocket);
    EXPECT_NEAR(frames.run(8), (8 + 30 - 5) * STEP, 1e-14) << "the first call opens with half a kick";
}

TEST(RegistryAndStep, AForceByTheCallerCountsForOneFrameBesideGenerators) {
    Frames frames;
    frames.run(3);
    frames.world.startFrame();
    frames.body->addForce(Vector3(100, 0, 0));
    frames.world.runPhysics(STEP);
    EXPECT_NEAR(frames.body->getVelocity().x, (4 + 100) * STEP, 1e-14);
    EXPECT_NEAR(frames.run(3), (7 + 100) * STEP, 1e-14);
}

TEST(RegistryAndStep, AFrameThatFailedIsForgottenByTheNextStart) {
    Frames frames;
    bool fails = false;
    Scripted failing([&](RigidBody *body) {
        body->addForce(Vector3(5, 0, 0));
        if (fails) throw std::runtime_error("no fuel");
    });
    frames.registry.add(frames.body, &failing);
    frames.run(2);
    fails = true;
    frames.world.startFrame();
    EXPECT_THROW(frames.world.runPhysics(STEP), std::runtime_error);
    fails = false;
    EXPECT_NEAR(frames.run(3), 5 * 6 * STEP, 1e-14);
}

TEST(RegistryAndStep, AGeneratorThatActsOnTwoBodiesKeepsTheirMomentum) {
    // A spring along X that pulls both of its ends in one call.
    World world;
    RigidBody *a = world.createBody(), *b = world.createBody();
    b->setPosition(3, 0, 0);
    b->setMass(2);
    Scripted spring([b](RigidBody *body) {
        const Vector3 pull = (b->getPosition() - body->getPosition()) * 10;
        body->addForce(pull);
        b->addForce(-pull);
    });
    world.getForceRegistry().add(a, &spring);
    for (int n = 0; n < 100; ++n) {
        world.startFrame();
        world.runPhysics(STEP);
        ASSERT_NEAR(a->getVelocity().x + 2 * b->getVelocity().x, 0, 1e-12) << "frame " << n;
    }
}

TEST(RegistryAndStep, BesideSuchAGeneratorTheCallersForcesStillCountForOneFrame) {
    Frames frames;
    RigidBody *other = frames.world.createBody();
    bool fails = false;
    Scripted both([&](RigidBody *body) {
        body->addForce(Vector3(2, 0, 0));
        other->addForce(Vector3(-2, 0, 0));
        if (fails) throw std::runtime_error("no fuel");
    });
    frames.registry.add(frames.body, &both);
    frames.run(3);
    fails = true;
    frames.world.startFrame();
    EXPECT_THROW(frames.world.runPhysics(STEP), std::runtime_error);
    fails = false;
    frames.world.startFrame();
    other->addForce(Vector3(50, 0, 0));
    frames.body->addForce(Vector3(100, 0, 0));
    frames.world.runPhysics(STEP);
    frames.run(3);
    EXPECT_NEAR(other->getVelocity().x, (-2 * 7 + 50) * STEP, 1e-14);
    EXPECT_NEAR(frames.body->getVelocity().x, (3 * 7 + 100) * STEP, 1e-14);
}

TEST(RegistryAndStep, AddedInMidFrameIsTheSameAsAddedBeforeTheNext) {
    AnchoredSpring spring(Vector3(0.1, 0, 0), Vector3(1, 2, 3), 10, 1);
    World world;
    RigidBody *late = world.createBody(), *early = world.createBody(), *another = world.createBody();
    bool adds = false;
    Scripted adder([&](RigidBody *) {
        if (adds) world.getForceRegistry().add(late, &spring);
        adds = false;
    });
    world.getForceRegistry().add(another, &adder);
    const auto frame = [&] {
        world.startFrame();
        world.runPhysics(STEP);
    };
    frame();
    adds = true;
    frame();
    world.getForceRegistry().add(early, &spring);
    for (int n = 0; n < 50; ++n) {
        frame();
        ASSERT_EQ(late->getVelocity(), early->getVelocity()) << "frame " << n;
        ASSERT_EQ(late->getOrientation(), early->getOrientation()) << "frame " << n;
    }
    EXPECT_NE(late->getVelocity(), Vector3());
}

}  // namespace
