#include "../../src/quickmath.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace cyclone;
using namespace cyclone::detail;

namespace {

TEST(QuickMath, SineAndCosineAreGoodTo1e11) {
    for (int n = -200000; n <= 200000; ++n) {
        const real angle = n * 0.0123457;
        const SineCosine quick = quickSineCosine(angle);
        ASSERT_NEAR(quick.sine, std::sin(angle), 1e-11) << angle;
        ASSERT_NEAR(quick.cosine, std::cos(angle), 1e-11) << angle;
    }
}

TEST(QuickMath, SineAndCosineOfHugeAnglesAreNoWorseThanTheAngle) {
    for (const real angle : {1048575.0, 1e7 + 0.3, -1e9, 3e12}) {
        const SineCosine quick = quickSineCosine(angle);
        EXPECT_NEAR(quick.sine, std::sin(angle), 1e-11 + std::fabs(angle) * REAL_EPSILON) << angle;
        EXPECT_NEAR(quick.cosine, std::cos(angle), 1e-11 + std::fabs(angle) * REAL_EPSILON) << angle;
    }
}

TEST(QuickMath, DecayIsGoodTo1e10) {
    for (int n = 0; n <= 100000; ++n) {
        const real x = -40.0 * n / 100000;
        ASSERT_NEAR(quickDecay(x) / std::exp(x), 1, 1e-10) << x;
    }
    EXPECT_EQ(quickDecay(0), 1);
}

}  // namespace
