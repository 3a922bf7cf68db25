#include <cyclone/precision.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

using namespace cyclone;

namespace {

constexpr real PLUS_INFINITY = std::numeric_limits<real>::infinity();
constexpr real QUIET_NAN = std::numeric_limits<real>::quiet_NaN();

/// What the error may be at most. precision.h promises one ulp; each function keeps a little of it in
/// reserve, a loss of which is noticed. Where long double has no digits to spare, the reference may err as
/// well.
constexpr long double toleranceOf(long double reached) {
    return std::numeric_limits<long double>::digits >= 64 ? reached : 1.9L;
}
/// Sums of two doubles are rounded once at the end; the last terms of a series before that.
constexpr long double ROUNDED_ONCE = toleranceOf(0.51L), WITH_SERIES = toleranceOf(0.66L);
/// Results that are subnormal are rounded twice, and the square in the cosine's first term is, too.
constexpr long double ROUNDED_TWICE = toleranceOf(0.8L);

/// The error of a result in units of the last place of the wanted value.
long double ulps(real got, long double want) {
    if (std::isnan(want)) return std::isnan(got) ? 0 : HUGE_VALL;
    if (static_cast<long double>(got) == want) return 0;
    if (!real_isfinite(got)) return static_cast<real>(want) == got ? 0 : HUGE_VALL;
    int exponent = 0;
    std::frexp(want, &exponent);
    const int last_place = exponent - 53 > -1074 ? exponent - 53 : -1074;
    return std::fabs(static_cast<long double>(got) - want) / std::ldexp(1.0L, last_place);
}

/// Remembers the worst of many comparisons.
struct Worst {
    const long double tolerance;
    long double error = 0;
    std::string where = std::string();

    void compare(real got, long double want, real x, real y = 0) {
        const long double e = ulps(got, want);
        if (e <= error || (e < ROUNDED_TWICE && std::fabs(want) < 0x1p-1022L)) return;
        error = e;
        char text[128];
        std::snprintf(text, sizeof text, "at %a, %a: %a instead of %La", x, y, got, want);
        where = text;
    }

    ~Worst() { EXPECT_LT(error, tolerance) << "ulp " << where; }
};

/// Evenly distributed 64-bit numbers (Steele, Lea and Flood, "Fast splittable pseudorandom number
/// generators", 2014: SplitMix64), and reals made of them.
struct Generator {
    std::uint64_t state;

    std::uint64_t bits() {
        std::uint64_t z = state += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    real between(real low, real high) {
        return low + (high - low) * (static_cast<real>(bits() >> 11) * 0x1p-53);
    }
    /// Every binade from 2^low to below 2^high is equally likely; never subnormal.
    real magnitude(int low, int high) {
        const int span = static_cast<int>(bits() % static_cast<std::uint64_t>(high - low));
        return std::ldexp(between(1, 2), low + span);
    }
    real signed_magnitude(int low, int high) {
        const real x = magnitude(low, high);
        return bits() & 1 ? x : -x;
    }
    /// Any finite number.
    real any() {
        for (;;) {
            const std::uint64_t b = bits();
            real x;
            std::memcpy(&x, &b, sizeof x);
            if (real_isfinite(x)) return x;
        }
    }
};

constexpr int SWEEP = 100000;

std::uint64_t bits_of(real x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}

/// Equal down to the sign of zero; a NaN equals any NaN.
void expect_same(real got, real want) {
    if (std::isnan(want)) {
        EXPECT_TRUE(std::isnan(got)) << got;
    } else {
        EXPECT_EQ(bits_of(got), bits_of(want)) << got << " instead of " << want;
    }
}

TEST(PrecisionTest, ClampsAndTellsFiniteNumbers) {
    EXPECT_EQ(real_clamp(-2, -1, 3), -1);
    EXPECT_EQ(real_clamp(0.5, -1, 3), 0.5);
    EXPECT_EQ(real_clamp(4, -1, 3), 3);
    EXPECT_TRUE(std::isnan(real_clamp(QUIET_NAN, -1, 3)));
    for (real x : {0.0, -1.0, REAL_MAX, -REAL_MAX, 5e-324}) EXPECT_TRUE(real_isfinite(x));
    for (real x : {PLUS_INFINITY, -PLUS_INFINITY, QUIET_NAN}) EXPECT_FALSE(real_isfinite(x));
}

// ---------------------------------------------------------------------------------------------
// Against the C library's long double functions
// ---------------------------------------------------------------------------------------------

TEST(PrecisionTest, ExpIsAccurate) {
    Generator random{1};
    Worst worst{WITH_SERIES};
    const auto check = [&](real x) { worst.compare(real_exp(x), std::exp(static_cast<long double>(x)), x); };
    for (int i = 0; i < SWEEP; ++i) {
        check(random.between(-1, 1));
        check(random.between(-746, 710));
        check(random.between(-746, -707));  // subnormal results
        check(random.signed_magnitude(-70, 9));
    }
}

TEST(PrecisionTest, LogIsAccurate) {
    Generator random{2};
    Worst worst{ROUNDED_ONCE};
    const auto check = [&](real x) { worst.compare(real_log(x), std::log(static_cast<long double>(x)), x); };
    for (int i = 0; i < SWEEP; ++i) {
        check(random.between(0.5, 2));
        check(1 + random.signed_magnitude(-53, -1));
        check(real_abs(random.any()));
        check(random.between(0, 0x1p-1022));  // subnormal arguments
    }
}

TEST(PrecisionTest, PowIsAccurate) {
    Generator random{3};
    Worst worst{WITH_SERIES};
    const auto check = [&](real x, real y) {
        worst.compare(real_pow(x, y), std::pow(static_cast<long double>(x), static_cast<long double>(y)), x,
                      y);
    };
    for (int i = 0; i < SWEEP; ++i) {
        const real damping = random.between(0, 1);
        check(damping, random.between(0, 0.1));
        // Results from the smallest subnormal to the largest number, bases from all binades.
        const real base = real_abs(random.any());
        check(base, random.between(-745, 710) / real_log(base));
        const real near_one = 1 + random.signed_magnitude(-53, -1);
        check(near_one, random.between(-745, 710) / real_log(near_one));
        // Subnormal bases and subnormal results.
        const real subnormal = random.between(0, 0x1p-1022);
        check(subnormal, random.between(-1, 1));
        check(base, random.between(-745, -707) / real_log(base));
    }
}

TEST(PrecisionTest, SineAndCosineAreAccurate) {
    Generator random{4};
    Worst sine{ROUNDED_TWICE}, cosine{ROUNDED_TWICE};
    const auto check = [&](real x) {
        sine.compare(real_sin(x), std::sin(static_cast<long double>(x)), x);
        cosine.compare(real_cos(x), std::cos(static_cast<long double>(x)), x);
    };
    for (int i = 0; i < SWEEP; ++i) {
        check(random.between(-7, 7));
        check(random.signed_magnitude(-40, 1023));
        // Next to multiples of a quarter turn, where digits cancel.
        const real quarters = std::floor(random.magnitude(0, 50));
        const real multiple = static_cast<real>(quarters * 1.57079632679489661923132169163975144L);
        check(multiple);
        check(std::nextafter(multiple, 0.0));
    }
}

TEST(PrecisionTest, Atan2IsAccurate) {
    Generator random{5};
    Worst worst{ROUNDED_ONCE};
    const auto check = [&](real y, real x) {
        worst.compare(real_atan2(y, x), std::atan2(static_cast<long double>(y), static_cast<long double>(x)),
                      y, x);
    };
    for (int i = 0; i < SWEEP; ++i) {
        const real a = random.between(-1, 1), b = random.between(-1, 1);
        check(a, b);
        check(a * 0x1p-1022, b * 0x1p-1022);
        check(a, std::ldexp(1 + real_abs(b), 1022));  // subnormal results
        const real y = random.any();
        check(y, random.any());
        const real slope = random.signed_magnitude(-62, 62);
        const real x = random.signed_magnitude(-960, 960);
        check(slope * x, x);
    }
}

TEST(PrecisionTest, AsinAndAcosAreAccurate) {
    Generator random{6};
    Worst sine{ROUNDED_ONCE}, cosine{ROUNDED_ONCE};
    const auto check = [&](real x) {
        sine.compare(real_asin(x), std::asin(static_cast<long double>(x)), x);
        cosine.compare(real_acos(x), std::acos(static_cast<long double>(x)), x);
    };
    for (int i = 0; i < SWEEP; ++i) {
        check(random.between(-1, 1));
        check(random.signed_magnitude(-60, 0));
        const real near_one = 1 - random.magnitude(-53, -1);
        check(near_one);
        check(-near_one);
    }
}

// ---------------------------------------------------------------------------------------------
// Against values computed with 1400 bits by integer arithmetic: series for exp and sin, artanh for log,
// Euler's series for arctan. `below` is the largest double not above the true value, so that the only
// results within one ulp are itself and its upper neighbour.
// ---------------------------------------------------------------------------------------------

void expect_neighbour(real got, real below) {
    const real above = std::nextafter(below, PLUS_INFINITY);
    EXPECT_TRUE(got == below || got == above) << std::hexfloat << got << " is not next to " << below;
}

struct GoldenUnary {
    real (*function)(real);
    real x, below;
};

struct GoldenBinary {
    real (*function)(real, real);
    real x, y, below;
};

constexpr GoldenUnary GOLDEN_UNARY[] = {
    {real_exp, 1.0, 0x1.5bf0a8b145769p+1},
    {real_exp, -1.0, 0x1.78b56362cef37p-2},
    {real_exp, 0.1, 0x1.1aec7b35a00d3p+0},
    {real_exp, 0x1.62e42fefa39efp-2, 0x1.6a09e667f3bccp+0},
    {real_exp, 20.5, 0x1.7d6c4f0bcdd5cp+29},
    {real_exp, -100.25, 0x1.4acd31e167ebap-145},
    {real_exp, 0x1.62e42fefa39efp+9, 0x1.fffffffffff2ap+1023},
    {real_exp, -708.5, 0x0.e6cf6d08897abp-1022},
    {real_exp, -730.3, 0x0.0000000151bffp-1022},
    {real_exp, -744.4, 0x0.0000000000001p-1022},
    {real_exp, -1e-17, 0x1.fffffffffffffp-1},
    {real_log, 2.0, 0x1.62e42fefa39efp-1},
    {real_log, 10.0, 0x1.26bb1bbb55515p+1},
    {real_log, 0.5, -0x1.62e42fefa39fp-1},
    {real_log, 0x1.000000006df38p+0, 0x1.b7cdffffa18d7p-34},
    {real_log, 0x1.fffffffffffffp-1, -0x1.0000000000001p-53},
    {real_log, 0x1.0000000000001p+0, 0x1.fffffffffffffp-53},
    {real_log, 0.7, -0x1.6d3c324e13f5p-2},
    {real_log, 0x1.6a09e667f3bcdp+0, 0x1.62e42fefa39fp-2},
    {real_log, 0x1.f8p-1, -0x1.0205658935848p-6},
    {real_log, 5e-324, -0x1.74385446d71c4p+9},
    {real_log, 0x1.fffffffffffffp+1023, 0x1.62e42fefa39efp+9},
    {real_log, 3e-310, -0x1.6459f44103e87p+9},
    {real_sin, 1.0, 0x1.aed548f090ceep-1},
    {real_sin, 0.5, 0x1.eaee8744b05efp-2},
    {real_sin, 3.0, 0x1.210386db6d55bp-3},
    {real_sin, 0x1.921fb54442d18p+1, 0x1.1a62633145c06p-53},
    {real_sin, -2.5, -0x1.326af0dcfcab1p-1},
    {real_sin, 0x1.921fb54442d18p-1, 0x1.6a09e667f3bccp-1},
    {real_sin, 100000.0, 0x1.24daa9c527e96p-5},
    {real_sin, 1e+22, -0x1.b453ab76bf398p-1},
    {real_sin, 0x1.fffffffffffffp+1023, 0x1.452fc98b34e96p-8},
    {real_sin, 0x1.6ac5b262ca1ffp+849, 0x1.fffffffffffffp-1},
    {real_sin, 1e-05, 0x1.4f8b588e1e8a2p-17},
    {real_sin, 0x1.4p+62, 0x1.f6e294c63176fp-1},
    {real_cos, 1.0, 0x1.14a280fb5068bp-1},
    {real_cos, 0.5, 0x1.c1528065b7d4fp-1},
    {real_cos, 3.0, -0x1.fae04be85e5d3p-1},
    {real_cos, 0x1.921fb54442d18p+0, 0x1.1a62633145c06p-54},
    {real_cos, 0x1.921fb54442d18p-1, 0x1.6a09e667f3bccp-1},
    {real_cos, 0x1.2d97c7f3321d2p+2, -0x1.a79394c9e8a0bp-53},
    {real_cos, 100000.0, -0x1.ffac3841b3da8p-1},
    {real_cos, 1e+22, 0x1.0be2cef01c8f3p-1},
    {real_cos, 0x1.fffffffffffffp+1023, -0x1.fffe62ecfab76p-1},
    {real_cos, 0x1.6ac5b262ca1ffp+849, -0x1.14ae72e6ba22fp-61},
    {real_cos, 1e-05, 0x1.ffffffff920c8p-1},
    {real_cos, 0x1.6c6cbc45dc8dep+5, -0x1.6d61b58c99c43p-61},
    {real_cos, 0x1.93c05c9ed3cbcp+18, -0x1.065d73720c4f9p-52},
    {real_cos, 0x1.4p+62, -0x1.80b853ab9298cp-3},
    {real_asin, 0.5, 0x1.0c152382d7365p-1},
    {real_asin, -0.3, -0x1.380159e14f6ffp-2},
    {real_asin, 0.99, 0x1.6de3c6f33d51dp+0},
    {real_asin, 0x1.fffffffffffffp-1, 0x1.921fb50442d18p+0},
    {real_asin, 1e-06, 0x1.0c6f7a0b5f0ap-20},
    {real_asin, 0x1.6a09e667f3bcdp-1, 0x1.921fb54442d18p-1},
    {real_asin, -1.0, -0x1.921fb54442d19p+0},
    {real_acos, 0.5, 0x1.0c152382d7365p+0},
    {real_acos, 0.99, 0x1.21df72882bfd7p-3},
    {real_acos, 0x1.fffffffffffffp-1, 0x1p-26},
    {real_acos, 1e-06, 0x1.921fa47d4b30cp+0},
    {real_acos, -0.9999, 0x1.90504b722c14p+1},
    {real_acos, -1.0, 0x1.921fb54442d18p+1},
    {real_acos, -0x1.fffffffffffffp-1, 0x1.921fb52442d18p+1},
};

constexpr GoldenBinary GOLDEN_BINARY[] = {
    {real_pow, 0.9, 0.5, 0x1.e5b9d136c6d96p-1},
    {real_pow, 0.8, 0x1.1111111111111p-7, 0x1.ff0c7e8490e3bp-1},
    {real_pow, 2.0, 0.5, 0x1.6a09e667f3bccp+0},
    {real_pow, 10.0, -3.0, 0x1.0624dd2f1a9fbp-10},
    {real_pow, 0.99, 0x1.1111111111111p-6, 0x1.ffea0bea600bep-1},
    {real_pow, 1.1, 7000.0, 0x1.70482352af339p+962},
    {real_pow, 0x1.0000000000001p+0, 3e+18, 0x1.0502174a9bef1p+961},
    {real_pow, 0x1.fffffffffffffp-1, 6.5e+18, 0x0.00001d939ead3p-1022},
    {real_pow, 1e-200, 1.6, 0x0.00000000007e8p-1022},
    {real_pow, -3.0, 33.0, -0x1.3bfefa65abb84p+52},
    {real_pow, -1.7, -501.0, -0x1.61dfc05070185p-384},
    {real_pow, 1e+300, 1.02, 0x1.6c8e5ca239077p+1016},
    {real_pow, 5e-324, 0.25, 0x1.6a09e667f3bccp-269},
    {real_pow, 3.7, -555.5, 0x0.0000002c9f75dp-1022},
    {real_pow, 0.5, 1073.25, 0x0.0000000000001p-1022},
    {real_atan2, 1.0, 2.0, 0x1.dac670561bb4fp-2},
    {real_atan2, 2.0, 1.0, 0x1.1b6e192ebbe44p+0},
    {real_atan2, 1.0, -3.0, 0x1.68f095fdf593cp+1},
    {real_atan2, -5.0, -4.0, -0x1.1f6dc3e631131p+1},
    {real_atan2, -5.0, 4.0, -0x1.cac7c57846f9fp-1},
    {real_atan2, 1e-300, 0x1.2a05f2p+33, 0x0.012688b70e62bp-1022},
    {real_atan2, 5e-324, 3e-323, 0x1.52397843c9addp-3},
    {real_atan2, 0x1.e42d130773b76p+1023, 0x1.55c576d815726p+1023, 0x1.e98a504f628ddp-1},
    {real_atan2, 1e-12, -1.0, 0x1.921fb5444244cp+1},
    {real_atan2, 1.0, 1e-20, 0x1.921fb54442d18p+0},
    {real_atan2, 0.0625, 1.0, 0x1.ff55bb72cfde9p-5},
    {real_atan2, 0.3, 0.8, 0x1.6f61941e4defp-2},
};

TEST(PrecisionTest, MatchesHighPrecisionValues) {
    for (const GoldenUnary &g : GOLDEN_UNARY) {
        SCOPED_TRACE(::testing::Message() << "row " << &g - GOLDEN_UNARY << ", x = " << g.x);
        expect_neighbour(g.function(g.x), g.below);
    }
    for (const GoldenBinary &g : GOLDEN_BINARY) {
        SCOPED_TRACE(::testing::Message()
                     << "row " << &g - GOLDEN_BINARY << ", x = " << g.x << ", y = " << g.y);
        expect_neighbour(g.function(g.x, g.y), g.below);
    }
}

// ---------------------------------------------------------------------------------------------
// Special values, thresholds, and results that are exact
// ---------------------------------------------------------------------------------------------

TEST(PrecisionTest, ExpAndLogOfSpecialValues) {
    expect_same(real_exp(0.0), 1);
    expect_same(real_exp(-0.0), 1);
    expect_same(real_exp(PLUS_INFINITY), PLUS_INFINITY);
    expect_same(real_exp(-PLUS_INFINITY), 0);
    expect_same(real_exp(QUIET_NAN), QUIET_NAN);
    EXPECT_LT(real_exp(0x1.62e42fefa39efp+9), PLUS_INFINITY);  // ln(2^1024), just below and just above
    expect_same(real_exp(0x1.62e42fefa39fp+9), PLUS_INFINITY);
    expect_same(real_exp(-0x1.74910d52d3051p+9), 5e-324);  // ln(2^-1075), just above and just below
    expect_same(real_exp(-0x1.74910d52d3052p+9), 0);
    expect_same(real_exp(REAL_MAX), PLUS_INFINITY);
    expect_same(real_exp(-REAL_MAX), 0);

    expect_same(real_log(1), 0);
    expect_same(real_log(0.0), -PLUS_INFINITY);
    expect_same(real_log(-0.0), -PLUS_INFINITY);
    expect_same(real_log(PLUS_INFINITY), PLUS_INFINITY);
    for (real x : {-1.0, -5e-324, -PLUS_INFINITY, QUIET_NAN}) expect_same(real_log(x), QUIET_NAN);
}

TEST(PrecisionTest, PowOfSpecialValues) {
    for (real x : {0.0, -0.0, 1.0, -1.0, 2.5, -2.5, REAL_MAX, PLUS_INFINITY, -PLUS_INFINITY, QUIET_NAN}) {
        SCOPED_TRACE(x);
        expect_same(real_pow(x, 0.0), 1);
        expect_same(real_pow(x, -0.0), 1);
        expect_same(real_pow(1, x), 1);
    }
    for (real x : {0.0, -0.0, 2.0, -2.0, PLUS_INFINITY}) {
        expect_same(real_pow(x, QUIET_NAN), QUIET_NAN);
        if (x != 0) expect_same(real_pow(QUIET_NAN, x), QUIET_NAN);
    }
    // Zero and infinity, with the sign kept by odd exponents only.
    for (real odd : {1.0, 3.0, 0x1.0000000000002p51, 0x1.0000000000001p52, 0x1.fffffffffffffp52}) {
        expect_same(real_pow(0.0, odd), 0.0);
        expect_same(real_pow(-0.0, odd), -0.0);
        expect_same(real_pow(0.0, -odd), PLUS_INFINITY);
        expect_same(real_pow(-0.0, -odd), -PLUS_INFINITY);
        expect_same(real_pow(-PLUS_INFINITY, odd), -PLUS_INFINITY);
        expect_same(real_pow(-PLUS_INFINITY, -odd), -0.0);
        expect_same(real_pow(-1, odd), -1);
        expect_same(real_pow(-1, -odd), -1);
    }
    for (real other : {2.0, 0.5, 1.5, 0x1p53, 0x1p70, PLUS_INFINITY}) {
        expect_same(real_pow(0.0, other), 0.0);
        expect_same(real_pow(-0.0, other), 0.0);
        expect_same(real_pow(0.0, -other), PLUS_INFINITY);
        expect_same(real_pow(-0.0, -other), PLUS_INFINITY);
        expect_same(real_pow(PLUS_INFINITY, other), PLUS_INFINITY);
        expect_same(real_pow(PLUS_INFINITY, -other), 0.0);
        expect_same(real_pow(-PLUS_INFINITY, other), PLUS_INFINITY);
        expect_same(real_pow(-PLUS_INFINITY, -other), 0.0);
    }
    for (real even : {2.0, 0x1p53, 0x1p70, PLUS_INFINITY}) {
        expect_same(real_pow(-1, even), 1);
        expect_same(real_pow(-1, -even), 1);
    }
    for (real huge : {0x1p65, REAL_MAX, PLUS_INFINITY}) {
        for (real x : {1.0000000000000002, 3.0, -3.0}) {
            expect_same(real_pow(x, huge), PLUS_INFINITY);
            expect_same(real_pow(x, -huge), 0.0);
            expect_same(real_pow(1 / x * 0.9999999999999998, huge), 0.0);
            expect_same(real_pow(1 / x * 0.9999999999999998, -huge), PLUS_INFINITY);
        }
    }
    for (real fraction : {0.5, -0.5, 1.5, 5e-324, 0x1.fffffffffffffp51}) {
        expect_same(real_pow(-2, fraction), QUIET_NAN);
        expect_same(real_pow(-1, fraction), QUIET_NAN);
    }
    expect_same(real_pow(3, 5e-324), 1);
    expect_same(real_pow(-3, 647), -PLUS_INFINITY);
    expect_same(real_pow(-3, -679), -0.0);
}

TEST(PrecisionTest, PowIsExactWhereTheResultIs) {
    for (int n = -1074; n < 1024; ++n) expect_same(real_pow(2, n), std::ldexp(1.0, n));
    real power_of_3 = 1, power_of_10 = 1;
    for (int n = 0; n <= 33; ++n, power_of_3 *= -3) expect_same(real_pow(-3, n), power_of_3);
    for (int n = 0; n <= 22; ++n, power_of_10 *= 10) expect_same(real_pow(10, n), power_of_10);
    for (int n = 1; n < 1000; ++n) {
        expect_same(real_pow(n, 1), n);
        expect_same(real_pow(n * n, 0.5), n);
    }
    expect_same(real_pow(2, 1024), PLUS_INFINITY);
    expect_same(real_pow(2, -1075.5), 0);
}

TEST(PrecisionTest, SineAndCosineOfSpecialValues) {
    expect_same(real_sin(0.0), 0.0);
    expect_same(real_sin(-0.0), -0.0);
    expect_same(real_sin(-5e-324), -5e-324);
    expect_same(real_cos(0.0), 1);
    expect_same(real_cos(-0.0), 1);
    for (real x : {PLUS_INFINITY, -PLUS_INFINITY, QUIET_NAN}) {
        expect_same(real_sin(x), QUIET_NAN);
        expect_same(real_cos(x), QUIET_NAN);
    }
    Generator random{7};
    for (int i = 0; i < 1000; ++i) {
        const real x = random.magnitude(-30, 1023);
        expect_same(real_sin(-x), -real_sin(x));
        expect_same(real_cos(-x), real_cos(x));
    }
}

TEST(PrecisionTest, Atan2OfSpecialValues) {
    const real half = REAL_PI / 2, quarter = REAL_PI / 4, three_quarters = 0x1.2d97c7f3321d2p+1;
    for (real s : {1.0, -1.0}) {
        SCOPED_TRACE(s);
        for (real x : {0.0, 5e-324, 1.0, PLUS_INFINITY}) {
            expect_same(real_atan2(s * 0.0, x), s * 0.0);
            expect_same(real_atan2(s * 0.0, -x), s * REAL_PI);
        }
        for (real y : {5e-324, 1.0, REAL_MAX, PLUS_INFINITY}) {
            expect_same(real_atan2(s * y, 0.0), s * half);
            expect_same(real_atan2(s * y, -0.0), s * half);
        }
        for (real y : {5e-324, 1.0, REAL_MAX}) {
            expect_same(real_atan2(s * y, PLUS_INFINITY), s * 0.0);
            expect_same(real_atan2(s * y, -PLUS_INFINITY), s * REAL_PI);
            expect_same(real_atan2(s * PLUS_INFINITY, y), s * half);
            expect_same(real_atan2(s * PLUS_INFINITY, -y), s * half);
            expect_same(real_atan2(s * y, y), s * quarter);
            expect_same(real_atan2(s * y, -y), s * three_quarters);
        }
        expect_same(real_atan2(s * PLUS_INFINITY, PLUS_INFINITY), s * quarter);
        expect_same(real_atan2(s * PLUS_INFINITY, -PLUS_INFINITY), s * three_quarters);
        expect_same(real_atan2(s * 5e-324, REAL_MAX), s * 0.0);
        expect_same(real_atan2(s * 5e-324, 1), s * 5e-324);
    }
    for (real x : {0.0, 1.0, PLUS_INFINITY, QUIET_NAN}) {
        expect_same(real_atan2(QUIET_NAN, x), QUIET_NAN);
        expect_same(real_atan2(x, QUIET_NAN), QUIET_NAN);
    }
}

TEST(PrecisionTest, AsinAndAcosOfSpecialValues) {
    expect_same(real_asin(0.0), 0.0);
    expect_same(real_asin(-0.0), -0.0);
    expect_same(real_asin(1), REAL_PI / 2);
    expect_same(real_asin(-1), -REAL_PI / 2);
    expect_same(real_asin(-5e-324), -5e-324);
    expect_same(real_acos(1), 0.0);
    expect_same(real_acos(-1), REAL_PI);
    expect_same(real_acos(0.0), REAL_PI / 2);
    expect_same(real_acos(-0.0), REAL_PI / 2);
    expect_same(real_acos(5e-324), REAL_PI / 2);
    for (real x : {1.0000000000000002, -1.0000000000000002, PLUS_INFINITY, -PLUS_INFINITY, QUIET_NAN}) {
        expect_same(real_asin(x), QUIET_NAN);
        expect_same(real_acos(x), QUIET_NAN);
    }
}

}  // namespace
