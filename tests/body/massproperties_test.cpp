// Mass properties against textbook values, against sums over a fine grid, and against each other.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "random.h"

namespace {

using namespace cyclone;
using namespace cyclone_test;
using cyclone_test::isNear;

const real PI = 3.14159265358979323846;

testing::AssertionResult isNear(const MassProperties &got, const MassProperties &want, real tolerance) {
    if (!(real_abs(got.getMass() - want.getMass()) <= tolerance))
        return testing::AssertionFailure() << "the mass is " << got.getMass() << ", not " << want.getMass();
    if (const auto near = cyclone_test::isNear(got.getCentre(), want.getCentre(), tolerance); !near)
        return testing::AssertionFailure() << "centre: " << near.message();
    return cyclone_test::isNear(got.getInertiaTensor(), want.getInertiaTensor(), tolerance);
}

// ---- Textbook values

TEST(MassProperties, OfSolidsAsInTextbooks) {
    const Mass twelve(12);
    const auto tensor = [](const MassProperties &solid) {
        EXPECT_EQ(solid.getMass(), 12);
        return solid.getInertiaTensor();
    };
    // m(b² + c²)/12 with edges 2, 4, 6
    EXPECT_TRUE(isNear(tensor(MassProperties::box(Vector3(1, 2, 3), twelve)), diagonal(52, 40, 20), 1e-13));
    // 2/5 m r²; 2/3 m r² for a shell
    EXPECT_TRUE(isNear(tensor(MassProperties::sphere(5, twelve)), diagonal(120, 120, 120), 1e-13));
    EXPECT_TRUE(isNear(tensor(MassProperties::sphere(5, twelve, 5)), diagonal(200, 200, 200), 1e-13));
    // m(b² + c²)/5
    EXPECT_TRUE(
        isNear(tensor(MassProperties::ellipsoid(Vector3(1, 2, 3), twelve)), diagonal(31.2, 24, 12), 1e-13));
    // m r²/2 along the axis, m(3r² + l²)/12 across; a tube m r², m(6r² + l²)/12
    EXPECT_TRUE(isNear(tensor(MassProperties::cylinder(2, 3, twelve)), diagonal(21, 24, 21), 1e-13));
    EXPECT_TRUE(isNear(tensor(MassProperties::cylinder(2, 3, twelve, 2)), diagonal(33, 48, 33), 1e-13));
    // 3/10 m r² along the axis, 3/20 m r² + 3/80 m h² across
    EXPECT_TRUE(isNear(tensor(MassProperties::cone(2, 4, twelve)), diagonal(14.4, 14.4, 14.4), 1e-13));
    EXPECT_EQ(MassProperties::cone(2, 4, twelve).getCentre(), Vector3(0, 1, 0));
    // rod m l²/12, about its end m l²/3; plate m a²/12 and m(a² + b²)/12; disc m r²/4 and m r²/2
    const MassProperties rod = MassProperties::box(Vector3(0, 1.5, 0), twelve);
    EXPECT_TRUE(isNear(tensor(rod), diagonal(9, 0, 9), 1e-13));
    EXPECT_TRUE(isNear(rod.getInertiaTensorAbout(Vector3(0, -1.5, 0)), diagonal(36, 0, 36), 1e-13));
    EXPECT_TRUE(isNear(tensor(MassProperties::box(Vector3(1, 0, 2), twelve)), diagonal(16, 20, 4), 1e-13));
    EXPECT_TRUE(isNear(tensor(MassProperties::cylinder(2, 0, twelve)), diagonal(12, 24, 12), 1e-13));
}

TEST(MassProperties, DensityTimesVolume) {
    const Density two(2);
    EXPECT_NEAR(MassProperties::box(Vector3(1, 2, 3), two).getMass(), 96, 1e-12);
    EXPECT_NEAR(MassProperties::sphere(3, two).getMass(), 72 * PI, 1e-12);
    EXPECT_NEAR(MassProperties::sphere(3, two, 1).getMass(), 72 * PI - 8.0 / 3 * PI, 1e-12);
    EXPECT_NEAR(MassProperties::ellipsoid(Vector3(1, 2, 3), two).getMass(), 16 * PI, 1e-12);
    EXPECT_NEAR(MassProperties::cylinder(3, 5, two).getMass(), 90 * PI, 1e-12);
    EXPECT_NEAR(MassProperties::cylinder(3, 5, two, 1).getMass(), 80 * PI, 1e-12);
    EXPECT_NEAR(MassProperties::capsule(3, 5, two).getMass(), 162 * PI, 1e-12);
    EXPECT_NEAR(MassProperties::cone(3, 5, two).getMass(), 30 * PI, 1e-12);
}

TEST(MassProperties, CapsuleBetweenSphereAndRod) {
    const Mass three(3);
    EXPECT_TRUE(isNear(MassProperties::capsule(0.7, 0, three), MassProperties::sphere(0.7, three), 1e-15));
    EXPECT_TRUE(
        isNear(MassProperties::capsule(1e-9, 4, three), MassProperties::box(Vector3(0, 2, 0), three), 1e-8));
    // Put together from a cylinder and two half spheres, whose tensor about the flat side's centre is half
    // that of a sphere.
    const real r = 0.5, l = 1.2, half = 2.0 / 3 * PI * r * r * r;
    const Vector3 flatToCentre(0, 3.0 / 8 * r, 0);
    const MassProperties atFlat(half, Vector3(),
                                diagonal(0.4 * half * r * r, 0.4 * half * r * r, 0.4 * half * r * r));
    const Matrix3 steiner =
        diagonal(half * flatToCentre.y * flatToCentre.y, 0, half * flatToCentre.y * flatToCentre.y);
    const MassProperties cap(half, flatToCentre, atFlat.getInertiaTensor() + steiner * -1);
    MassProperties whole = MassProperties::cylinder(r, l, Density(1));
    whole += cap.placedAt(Vector3(0, l / 2, 0));
    whole += cap.placedAt(Vector3(0, -l / 2, 0), Quaternion::fromAxisAngle(Vector3::X, PI));
    EXPECT_TRUE(isNear(MassProperties::capsule(r, l, Density(1)), whole, 1e-14));
}

// ---- Sums over a grid

/// Mass, first and second moments of what `contains` says, at density 1, by the midpoints of small cubes.
MassProperties sumOverGrid(const std::function<bool(const Vector3 &)> &contains, real extent) {
    const int count = 140;
    const real edge = 2 * extent / count, volume = edge * edge * edge;
    real mass = 0, xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
    Vector3 moment;
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b)
            for (int c = 0; c < count; ++c) {
                const Vector3 p(edge * (a + 0.5) - extent, edge * (b + 0.5) - extent,
                                edge * (c + 0.5) - extent);
                if (!contains(p)) continue;
                mass += volume;
                moment += p * volume;
                xx += p.x * p.x * volume, yy += p.y * p.y * volume, zz += p.z * p.z * volume;
                xy += p.x * p.y * volume, xz += p.x * p.z * volume, yz += p.y * p.z * volume;
            }
    const Vector3 centre = moment * (1 / mass);
    xx -= mass * centre.x * centre.x, yy -= mass * centre.y * centre.y, zz -= mass * centre.z * centre.z;
    xy -= mass * centre.x * centre.y, xz -= mass * centre.x * centre.z, yz -= mass * centre.y * centre.z;
    Matrix3 tensor;
    tensor.setInertiaTensorCoeffs(yy + zz, xx + zz, xx + yy, xy, xz, yz);
    return MassProperties(mass, centre, tensor);
}

TEST(MassProperties, OfSolidsAsSummedOverAGrid) {
    const Density one(1);
    const auto across = [](const Vector3 &p) { return p.x * p.x + p.z * p.z; };
    struct Case {
        std::string name;
        MassProperties solid;
        std::function<bool(const Vector3 &)> contains;
    };
    const Case cases[] = {
        {"hollow sphere", MassProperties::sphere(0.9, one, 0.5),
         [](const Vector3 &p) { return p.magnitude() < 0.9 && p.magnitude() > 0.5; }},
        {"ellipsoid", MassProperties::ellipsoid(Vector3(0.5, 0.7, 0.9), one),
         [](const Vector3 &p) { return Vector3(p.x / 0.5, p.y / 0.7, p.z / 0.9).magnitude() < 1; }},
        {"tube", MassProperties::cylinder(0.8, 1.2, one, 0.6),
         [&](const Vector3 &p) { return real_abs(p.y) < 0.6 && across(p) < 0.64 && across(p) > 0.36; }},
        {"capsule", MassProperties::capsule(0.4, 0.9, one),
         [](const Vector3 &p) {
             return (p - Vector3(0, real_clamp(p.y, -0.45, 0.45), 0)).magnitude() < 0.4;
         }},
        {"cone", MassProperties::cone(0.8, 0.8, one),
         [&](const Vector3 &p) { return p.y > 0 && p.y < 0.8 && real_sqrt(across(p)) < 0.8 - p.y; }},
    };
    for (const Case &test : cases)
        EXPECT_TRUE(isNear(test.solid, sumOverGrid(test.contains, 1), 5e-3)) << test.name;
}

TEST(MassProperties, OfPartsAsSummedOverAGrid) {
    const Quaternion turn = Quaternion::fromAxisAngle(Vector3(1, 2, -1), 0.7);
    const Vector3 boxAt(-0.4, -0.3, -0.2), ballAt(0.5, 0.4, 0.3);
    const MassProperties both =
        MassProperties::box(Vector3(0.2, 0.5, 0.3), Density(1)).placedAt(boxAt, turn) +
        MassProperties::sphere(0.35, Density(1)).placedAt(ballAt);
    const MassProperties sum = sumOverGrid(
        [&](const Vector3 &p) {
            const Vector3 inBox = turn.conjugate().rotate(p - boxAt);
            return (p - ballAt).magnitude() < 0.35 ||
                   (real_abs(inBox.x) < 0.2 && real_abs(inBox.y) < 0.5 && real_abs(inBox.z) < 0.3);
        },
        1);
    EXPECT_TRUE(isNear(both, sum, 1e-3));
    // Products of inertia are there to be got right.
    EXPECT_GT(real_abs(both.getInertiaTensor().data[1]), 0.05);
}

// ---- Parts and wholes

TEST(MassProperties, EightBoxesMakeABox) {
    const Vector3 half(0.3, 1.1, 0.7);
    MassProperties whole;
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3 at((corner & 1 ? 0.5 : -0.5) * half.x, (corner & 2 ? 0.5 : -0.5) * half.y,
                         (corner & 4 ? 0.5 : -0.5) * half.z);
        whole += MassProperties::box(half * 0.5, Density(3)).placedAt(at);
    }
    EXPECT_TRUE(isNear(whole, MassProperties::box(half, Density(3)), 1e-14));
}

TEST(MassProperties, ASphereFitsInAShell) {
    const MassProperties whole =
        MassProperties::sphere(2, Density(5), 0.8) + MassProperties::sphere(0.8, Density(5));
    EXPECT_TRUE(isNear(whole, MassProperties::sphere(2, Density(5)), 1e-11));
}

TEST(MassProperties, OrderAndPlaceOfAssemblyDoNotMatter) {
    Random random(7);
    for (int n = 0; n < 100; ++n) {
        const auto part = [&] {
            const real mass = random.between(0.1, 5);
            const Vector3 size = random.vector() + Vector3(1.1, 1.1, 1.1);
            return MassProperties::box(size, Mass(mass)).placedAt(random.vector(3), random.orientation());
        };
        const MassProperties a = part(), b = part(), c = part();
        const MassProperties whole = (a + b) + c;
        EXPECT_TRUE(isNear(a + (b + c), whole, 1e-12));
        EXPECT_TRUE(isNear(c + a + b, whole, 1e-12));

        const Vector3 at = random.vector(10);
        const Quaternion turn = random.orientation();
        EXPECT_TRUE(isNear(a.placedAt(at, turn) + b.placedAt(at, turn) + c.placedAt(at, turn),
                           whole.placedAt(at, turn), 1e-10));
        EXPECT_TRUE(isNear(whole.placedAt(at, turn).placedAt(-turn.conjugate().rotate(at), turn.conjugate()),
                           whole, 1e-10));
        EXPECT_TRUE(isNear(whole.placedAt(at, Quaternion(3 * turn.r, 3 * turn.i, 3 * turn.j, 3 * turn.k)),
                           whole.placedAt(at, turn), 1e-10));
        // What is about another point does not care which part is looked at first.
        EXPECT_TRUE(isNear(
            whole.getInertiaTensorAbout(at),
            a.getInertiaTensorAbout(at) + b.getInertiaTensorAbout(at) + c.getInertiaTensorAbout(at), 1e-9));
    }
}

TEST(MassProperties, TurningATensorTurnsItsAxes) {
    // A quarter turn about Z lays a cylinder along X.
    const MassProperties lying = MassProperties::cylinder(1, 6, Mass(4))
                                     .placedAt(Vector3(), Quaternion::fromAxisAngle(Vector3::Z, PI / 2));
    EXPECT_TRUE(isNear(lying.getInertiaTensor(), diagonal(2, 13, 13), 1e-14));
}

TEST(MassProperties, NothingAddsNothing) {
    const MassProperties part = MassProperties::box(Vector3(1, 2, 3), Mass(4)).placedAt(Vector3(5, 6, 7));
    EXPECT_TRUE(isNear(MassProperties() + part, part, 0));
    EXPECT_TRUE(isNear(part + MassProperties(), part, 0));
    EXPECT_TRUE(isNear(MassProperties() + MassProperties(), MassProperties(), 0));
}

TEST(MassProperties, EverySumKeepsTheTriangleInequality) {
    Random random(8);
    for (int n = 0; n < 200; ++n) {
        MassProperties whole;
        for (int m = 0; m < 3; ++m)  // rods and points are at the very edge of what is possible
            whole += MassProperties::box(Vector3(0, random.between(0, 2), 0), Mass(random.between(1, 2)))
                         .placedAt(random.vector(), random.orientation());
        EXPECT_NO_THROW(MassProperties(whole.getMass(), whole.getCentre(), whole.getInertiaTensor()));
    }
}

TEST(MassProperties, OfAPointAndOfARodAreAtTheEdgeOfWhatIsPossible) {
    EXPECT_TRUE(
        isNear(MassProperties(2, Vector3(), diagonal(0, 0, 0)), MassProperties::box(Vector3(), Mass(2)), 0));
    const Matrix3 rod = MassProperties(2, Vector3(), diagonal(1, 1e-10, 1 + 2e-10)).getInertiaTensor();
    EXPECT_LE(rod.data[8], rod.data[0] + rod.data[4] + 1e-15) << "rounding is taken back";
    EXPECT_TRUE(cyclone_test::isNear(rod, diagonal(1, 0, 1), 1e-9));
}

// ---- Bodies

TEST(MassProperties, ABodyTakesThemOn) {
    MassProperties boat = MassProperties::box(Vector3(2, 0.3, 0.6), Mass(150));
    boat += MassProperties::cylinder(0.05, 8, Density(700)).placedAt(Vector3(0.2, 4.3, 0));

    RigidBody body;
    body.setPosition(1, 2, 3);
    body.setRotation(0.1, 0.2, 0.3);
    boat.applyTo(body);
    EXPECT_EQ(body.getMass(), boat.getMass());
    EXPECT_TRUE(isNear(body.getInertiaTensor(), boat.getInertiaTensor(), 1e-10));
    EXPECT_EQ(body.getPosition(), Vector3(1, 2, 3));
    EXPECT_EQ(body.getRotation(), Vector3(0.1, 0.2, 0.3));
    const Vector3 momentum = boat.getInertiaTensor() * body.getRotation();
    EXPECT_TRUE(isNear(body.getAngularMomentum(), momentum, 1e-10));
}

TEST(MassProperties, AHammerThrownTurnsAboutItsCentre) {
    const MassProperties hammer =
        MassProperties::box(Vector3(0.15, 0.02, 0.02), Mass(0.4)) +
        MassProperties::box(Vector3(0.02, 0.06, 0.02), Mass(1)).placedAt(Vector3(0.17, 0, 0));
    RigidBody body;
    hammer.applyTo(body);
    // A blow at the grip's end, across: the grip's end moves at F(1/m + r²/I).
    const Vector3 grip = Vector3(-0.15, 0, 0) - hammer.getCentre();
    const real lever = 0.15 + 0.17 / 1.4;
    const real inertia = 0.4 * (0.09 + 0.0016) / 12 + (0.0016 + 0.0144) / 12 + 0.4 / 1.4 * 0.17 * 0.17;
    body.addForceAtBodyPoint(Vector3(0, 10, 0), grip);
    body.integrate(1e-6);
    const Vector3 velocity = body.getVelocity() + body.getRotation() % grip;
    EXPECT_NEAR(velocity.y, 1e-5 * (1 / 1.4 + lever * lever / inertia), 1e-12);
}

// ---- Errors

std::string refusal(const std::function<void()> &action) {
    try {
        action();
    } catch (const std::invalid_argument &error) {
        return error.what();
    }
    return "accepted";
}

TEST(MassProperties, WhatIsRefused) {
    const Mass one(1);
    const real bad[] = {-1, QUIET_NAN, PLUS_INFINITY};
    const Matrix3 unit = diagonal(1, 1, 1);
    for (const real value : bad) {
        const std::pair<const char *, std::function<void()>> calls[] = {
            {"MassProperties::MassProperties: the mass", [&] { MassProperties(value, Vector3(), unit); }},
            {"MassProperties::MassProperties: the tensor",
             [&] { MassProperties(1, Vector3(), diagonal(value, 1, 1)); }},
            {"MassProperties::box: half", [&] { MassProperties::box(Vector3(1, value, 1), one); }},
            {"MassProperties::box: the mass", [&] { MassProperties::box(Vector3(1, 1, 1), Mass(value)); }},
            {"MassProperties::box: the mass", [&] { MassProperties::box(Vector3(1, 1, 1), Density(value)); }},
            {"MassProperties::sphere: the radius", [&] { MassProperties::sphere(value, one); }},
            {"MassProperties::sphere: the inner", [&] { MassProperties::sphere(1, one, value); }},
            {"MassProperties::ellipsoid: half",
             [&] { MassProperties::ellipsoid(Vector3(1, 1, value), one); }},
            {"MassProperties::cylinder: the radius", [&] { MassProperties::cylinder(value, 1, one); }},
            {"MassProperties::cylinder: the length", [&] { MassProperties::cylinder(1, value, one); }},
            {"MassProperties::cylinder: the inner", [&] { MassProperties::cylinder(1, 1, one, value); }},
            {"MassProperties::capsule: the radius", [&] { MassProperties::capsule(value, 1, one); }},
            {"MassProperties::capsule: the length", [&] { MassProperties::capsule(1, value, one); }},
            {"MassProperties::cone: the radius", [&] { MassProperties::cone(value, 1, one); }},
            {"MassProperties::cone: the height", [&] { MassProperties::cone(1, value, one); }}};
        for (const auto &[start, call] : calls) EXPECT_EQ(refusal(call).find(start), 0u) << start << value;
    }
    const std::pair<const char *, std::function<void()>> calls[] = {
        {"MassProperties::MassProperties: the mass", [&] { MassProperties(0, Vector3(), unit); }},
        {"MassProperties::MassProperties: the centre",
         [&] { MassProperties(1, Vector3(0, QUIET_NAN, 0), unit); }},
        // not symmetric; three moments that no thing has; the same in oblique axes; a negative one
        {"MassProperties::MassProperties: the tensor",
         [&] { MassProperties(1, Vector3(), Matrix3(1, 0.1, 0, 0, 1, 0, 0, 0, 1)); }},
        {"MassProperties::MassProperties: the tensor",
         [&] { MassProperties(1, Vector3(), diagonal(1, 1, 2.1)); }},
        {"MassProperties::MassProperties: the tensor",
         [&] { MassProperties(1, Vector3(), Matrix3(2, 1.1, 0, 1.1, 2, 0, 0, 0, 0.5)); }},
        {"MassProperties::MassProperties: the tensor",
         [&] { MassProperties(1, Vector3(), Matrix3(1, 1.1, 0, 1.1, 1, 0, 0, 0, 2)); }},
        {"MassProperties::sphere: the radius", [&] { MassProperties::sphere(0, one); }},
        {"MassProperties::sphere: the inner", [&] { MassProperties::sphere(1, one, 1.1); }},
        {"MassProperties::sphere: the mass", [&] { MassProperties::sphere(1, Density(1), 1); }},
        {"MassProperties::sphere: sizes", [&] { MassProperties::sphere(1e200, one); }},
        {"MassProperties::cylinder: the mass", [&] { MassProperties::cylinder(1, 0, Density(1)); }},
        {"MassProperties::cone: the height", [&] { MassProperties::cone(1, 0, one); }},
        {"MassProperties::placedAt: the position",
         [&] { MassProperties().placedAt(Vector3(PLUS_INFINITY, 0, 0)); }},
        {"MassProperties::placedAt: the orientation",
         [&] { MassProperties().placedAt(Vector3(), Quaternion(0, 0, 0, 0)); }},
        {"MassProperties::placedAt: the centre",
         [&] {
             MassProperties::sphere(1, one)
                 .placedAt(Vector3(REAL_MAX, 0, 0))
                 .placedAt(Vector3(REAL_MAX, 0, 0));
         }},
        {"MassProperties::applyTo: the mass",
         [&] {
             RigidBody body;
             MassProperties().applyTo(body);
         }},
        {"MassProperties::operator+: the sum", [&] {
             MassProperties::sphere(1, one) + MassProperties::sphere(1, one).placedAt(Vector3(0, 1e200, 0));
         }}};
    for (const auto &[start, call] : calls) EXPECT_EQ(refusal(call).find(start), 0u) << refusal(call);
}

TEST(MassProperties, ABodyThatRefusesThemStaysAsItWas) {
    RigidBody body;
    body.setMass(7);
    EXPECT_THROW(MassProperties().applyTo(body), std::invalid_argument);
    EXPECT_THROW(MassProperties::box(Vector3(0, 1, 0), Mass(2)).applyTo(body), std::invalid_argument);
    EXPECT_THROW(MassProperties(2, Vector3(), Matrix3()).applyTo(body), std::invalid_argument);
    EXPECT_EQ(body.getMass(), 7);
    EXPECT_EQ(body.getInertiaTensor(), diagonal(1, 1, 1));
}

}  // namespace

TEST(MassProperties, ASumOfMassesThatOverflowsIsRefused) {
    const MassProperties half = MassProperties::sphere(1e-3, Mass(0.9e308));
    EXPECT_EQ(refusal([&] { half + half; }).find("MassProperties::operator+: the sum"), 0u);
}
