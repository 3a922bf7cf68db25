#include <cyclone/precision.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

// Each function runs through the same phases: special values, reduce, approximate by the Taylor series,
// undo the reduction. Whatever must be better than a double is carried as an unevaluated sum of two.
// Reductions keep the series short enough for its terms beyond the first to need no more than a double.

namespace cyclone {
namespace {

constexpr real PLUS_INFINITY = std::numeric_limits<real>::infinity();
constexpr real QUIET_NAN = std::numeric_limits<real>::quiet_NaN();
constexpr real SMALLEST_NORMAL = std::numeric_limits<real>::min();

/// Below it sin(x), asin(x) and atan(x) are x, to a thousandth of an ulp and better.
constexpr real TINY = 0x1p-30;

// ---- Bits

std::uint64_t to_bits(real x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}

real from_bits(std::uint64_t bits) {
    real x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

constexpr std::uint64_t FRACTION_BITS = (std::uint64_t{1} << 52) - 1;

/// The e of x = m * 2^e, 1 <= m < 2, for normal positive x.
int exponent_of(real x) { return static_cast<int>(to_bits(x) >> 52) - 1023; }

/// 2^n for -1022 <= n <= 1023.
real power_of_two(int n) { return from_bits(static_cast<std::uint64_t>(n + 1023) << 52); }

/// The nearest integer, for |x| < 2^51: adding 1.5 * 2^52 leaves no room for a fraction.
real round_to_integer(real x) { return (x + 0x1.8p52) - 0x1.8p52; }

// ---------------------------------------------------------------------------------------------
// Arithmetic on unevaluated sums of two doubles (Dekker, "A floating-point technique for extending
// the available precision", 1971; Knuth, "The Art of Computer Programming", volume 2, 4.2.2).
// ---------------------------------------------------------------------------------------------

struct DoubleDouble {
    real high, low;
};

/// a + b exactly.
DoubleDouble sum(real a, real b) {
    const real s = a + b;
    const real b_part = s - a;
    return {s, (a - (s - b_part)) + (b - b_part)};
}

/// a + b exactly, if a is zero or |a| >= |b|.
DoubleDouble ordered_sum(real a, real b) {
    const real s = a + b;
    return {s, b - (s - a)};
}

/// The upper half of the digits of x, so that products of halves are exact.
real upper_half(real x) {
    const real shifted = x * 0x1.0000002p27;  // 2^27 + 1
    return shifted - (shifted - x);
}

/// a * b exactly, as long as nothing overflows or underflows.
DoubleDouble product(real a, real b) {
    const real p = a * b;
    const real a1 = upper_half(a), a2 = a - a1;
    const real b1 = upper_half(b), b2 = b - b1;
    return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
}

DoubleDouble add(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble s = sum(a.high, b.high);
    return ordered_sum(s.high, s.low + (a.low + b.low));
}

DoubleDouble negate(DoubleDouble a) { return {-a.high, -a.low}; }

DoubleDouble multiply(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble p = product(a.high, b.high);
    return {p.high, p.low + (a.high * b.low + a.low * b.high)};
}

DoubleDouble divide(DoubleDouble a, DoubleDouble b) {
    const real quotient = a.high / b.high;
    const DoubleDouble p = product(quotient, b.high);
    const real remainder = ((a.high - p.high) - p.low) + (a.low - quotient * b.low);
    return {quotient, remainder / b.high};
}

DoubleDouble square_root(DoubleDouble a) {
    const real root = real_sqrt(a.high);
    if (root == 0) return {0, 0};
    const DoubleDouble square = product(root, root);
    const real remainder = ((a.high - square.high) - square.low) + a.low;
    return {root, remainder / (2 * root)};
}

/// c[0] + c[1] x + c[2] x^2 + ... by Horner's rule.
template <std::size_t N>
real polynomial(real x, const real (&c)[N]) {
    real value = c[N - 1];
    for (std::size_t i = N - 1; i-- > 0;) value = c[i] + x * value;
    return value;
}

// ---- Exponential and logarithm

/// ln 2 in two parts (Cody and Waite, "Software Manual for the Elementary Functions", 1980):
/// the first is a multiple of 2^-42, so that integers up to 2^11 times it are exact.
constexpr DoubleDouble LN2 = {0x1.62e42fefa38p-1, 0x1.ef35793c7673p-45};
constexpr real INVERSE_LN2 = 0x1.71547652b82fep+0;

/// x * 2^n, rounded once, where x is near 1.
real scale(real x, int n) { return x * power_of_two(n / 2) * power_of_two(n - n / 2); }

/// e^x. Writes x = k ln 2 + r with |r| <= ln 2 / 2; then e^x = 2^k e^r.
real exponential(DoubleDouble x) {
    if (x.high > 710) return PLUS_INFINITY;
    if (x.high < -746) return 0;

    const real k = round_to_integer(x.high * INVERSE_LN2);
    const DoubleDouble r = sum(x.high - k * LN2.high, x.low - k * LN2.low);

    // e^r = 1 + r + r^2 (1/2! + r/3! + r^2/4! + ...), in two interleaved halves for speed.
    static constexpr real EVEN[] = {1.0 / 2,       1.0 / 24,        1.0 / 720,        1.0 / 40320,
                                    1.0 / 3628800, 1.0 / 479001600, 1.0 / 87178291200};
    static constexpr real ODD[] = {1.0 / 6,      1.0 / 120,      1.0 / 5040,
                                   1.0 / 362880, 1.0 / 39916800, 1.0 / 6227020800};
    const real r2 = r.high * r.high;
    const real tail = r2 * (polynomial(r2, EVEN) + r.high * polynomial(r2, ODD));
    const DoubleDouble head = ordered_sum(1, r.high);
    const real power = head.high + (head.low + (r.low + r.low * r.high + tail));

    return scale(power, static_cast<int>(k));
}

/// ln(j / 32) for j = 23 ... 45; the first parts are multiples of 2^-42, as that of ln 2.
constexpr int FIRST_LOG = 23;
constexpr DoubleDouble LOG[] = {
    {-0x1.522ae0738ap-2, -0x1.ebe708164c759p-45}, {-0x1.269621134ep-2, 0x1.1b61f10522625p-44},
    {-0x1.f991c6cb3cp-3, 0x1.90d04cd7cc834p-44},  {-0x1.a93ed3c8aep-3, 0x1.8724350562169p-45},
    {-0x1.5bf406b544p-3, 0x1.27023eb68981cp-46},  {-0x1.1178e8227ep-3, -0x1.1ef78ce2d07f2p-45},
    {-0x1.9335e5d594p-4, -0x1.3115c3abd47dap-45}, {-0x1.08598b59e4p-4, 0x1.7e5dd7009902cp-46},
    {-0x1.0415d89e78p-5, 0x1.dddc7f461c516p-44},  {0, 0},
    {0x1.f829b0e78p-6, 0x1.980267c7e09e4p-45},    {0x1.f0a30c0118p-5, -0x1.d599e83368e91p-45},
    {0x1.6f0d28ae58p-4, -0x1.4b4641b664613p-44},  {0x1.e27076e2bp-4, -0x1.a342c2af0003cp-45},
    {0x1.29552f82p-3, -0x1.5b967f4471dfcp-44},    {0x1.5ff3070a7ap-3, -0x1.8586f183bebf2p-44},
    {0x1.9525a9cf46p-3, -0x1.297137d9f158fp-44},  {0x1.c8ff7c79aap-3, -0x1.7794f689f8434p-45},
    {0x1.fb9186d5e4p-3, -0x1.d572aab993c87p-47},  {0x1.1675cababap-2, 0x1.8380e731f55c4p-44},
    {0x1.2e8e2bae12p-2, -0x1.67b1e99b72bd8p-45},  {0x1.4618bc21c6p-2, -0x1.3d82f484c84ccp-46},
    {0x1.5d1bdbf581p-2, -0x1.8d6bdc9c7c238p-44},
};

/// ln x for positive finite x, to about 2^-66 of itself.
/// Writes x = 2^k m with m in [sqrt 1/2, sqrt 2], and m = c (1 + s) / (1 - s) with c = j/32 nearest to m;
/// then ln x = k ln 2 + ln c + 2 artanh s, where |s| <= 1/90.
DoubleDouble logarithm(real x) {
    int k = 0;
    if (x < SMALLEST_NORMAL) {
        x *= 0x1p54;
        k = -54;
    }
    k += exponent_of(x);
    real m = from_bits((to_bits(x) & FRACTION_BITS) | to_bits(1.0));
    if (m > 1.4142135623730951) {
        m *= 0.5;
        ++k;
    }
    const int j = static_cast<int>(m * 32 + 0.5);
    const real c = j * (1.0 / 32);
    const DoubleDouble s = divide({m - c, 0}, sum(m, c));

    // artanh s = s + s^3/3 + s^5/5 + ...
    static constexpr real ARTANH[] = {1.0 / 3, 1.0 / 5, 1.0 / 7, 1.0 / 9, 1.0 / 11};
    const real s2 = s.high * s.high;
    const real tail = s.high * s2 * polynomial(s2, ARTANH);

    const DoubleDouble log_c = LOG[j - FIRST_LOG];
    const DoubleDouble base = {k * LN2.high + log_c.high, k * LN2.low + log_c.low};
    const DoubleDouble head = ordered_sum(base.high, 2 * s.high);
    return ordered_sum(head.high, head.low + (base.low + 2 * (s.low + tail)));
}

bool is_integer(real x) {
    return real_abs(x) >= 0x1p53 || static_cast<real>(static_cast<std::int64_t>(x)) == x;
}

bool is_odd_integer(real x) {
    return real_abs(x) < 0x1p53 && is_integer(x) && (static_cast<std::int64_t>(x) & 1) != 0;
}

// ---- Sine and cosine

constexpr DoubleDouble HALF_PI = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr DoubleDouble PI = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

/// An angle less whole quarter turns: quarters * pi/2 + rest, |rest| <= pi/4 (a hair more, by rounding).
struct QuarterTurns {
    int quarters;  // modulo 4
    DoubleDouble rest;
};

/// For 0.5 < |angle| < 2^20: pi/2 in three parts (Cody and Waite), the first two of 33 bits, so that their
/// multiples are exact. The rest is good to 2^-98.
QuarterTurns reduce_moderate(real angle) {
    const real n = round_to_integer(angle * 0x1.45f306dc9c883p-1);
    const DoubleDouble r = sum(angle - n * 0x1.921fb544p+0, -(n * 0x1.0b4611a6p-34));
    return {static_cast<int>(n) & 3, ordered_sum(r.high, r.low - n * 0x1.3198a2e037073p-69)};
}

/// The bits of 2/pi after the binary point, behind 64 zeros.
constexpr std::uint64_t TWO_OVER_PI[] = {
    0,
    0xa2f9836e4e441529,
    0xfc2757d1f534ddc0,
    0xdb6295993c439041,
    0xfe5163abdebbc561,
    0xb7246e3a424dd2e0,
    0x06492eea09d1921c,
    0xfe1deb1cb129a73e,
    0xe88235f52ebb4484,
    0xe99c7026b45f7e41,
    0x3991d639835339f4,
    0x9c845f8bbdf9283b,
    0x1ff897ffde05980f,
    0xef2f118b5a0a6d1f,
    0x6d367ecf27cb09b7,
    0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b,
    0x3d0739f78a5292ea,
    0x6bfb5fb11f8d5d08,
    0x56033046fc7b6bab,
};

/// 64 bits of TWO_OVER_PI from the given bit on.
std::uint64_t two_over_pi_bits(int first) {
    const int word = first / 64, shift = first % 64;
    if (shift == 0) return TWO_OVER_PI[word];
    return TWO_OVER_PI[word] << shift | TWO_OVER_PI[word + 1] >> (64 - shift);
}

/// The upper 64 bits of the 128-bit product.
std::uint64_t multiply_high(std::uint64_t a, std::uint64_t b) {
    const std::uint64_t mask = 0xffffffff;
    const std::uint64_t a1 = a >> 32, a0 = a & mask, b1 = b >> 32, b0 = b & mask;
    const std::uint64_t cross = a1 * b0 + (a0 * b0 >> 32);
    const std::uint64_t middle = a0 * b1 + (cross & mask);
    return a1 * b1 + (cross >> 32) + (middle >> 32);
}

/// bits * 2^-64 exactly.
DoubleDouble fraction(std::uint64_t bits) {
    return ordered_sum(static_cast<real>(bits >> 32) * 0x1p-32,
                       static_cast<real>(bits & 0xffffffff) * 0x1p-64);
}

/// For any angle > 0.5 (Payne and Hanek, "Radian reduction for trigonometric functions", 1983): with
/// angle = m * 2^e, m an integer, those bits of 2/pi that would only add multiples of 4 to the quotient
/// are skipped, and the 192 that follow suffice: no double comes closer to a multiple of pi/2 than 2^-61.
QuarterTurns reduce_any(real angle) {
    const std::uint64_t m = (to_bits(angle) & FRACTION_BITS) | (FRACTION_BITS + 1);
    const int first = exponent_of(angle) + 10;  // the bit with which an m of 1 would add 2

    // The quotient modulo 4, its binary point after two bits: 64 upper bits, 64 lower bits.
    const std::uint64_t middle_bits = two_over_pi_bits(first + 64);
    const std::uint64_t from_last = multiply_high(m, two_over_pi_bits(first + 128));
    std::uint64_t lower = m * middle_bits + from_last;
    const std::uint64_t carry = lower < from_last ? 1 : 0;
    std::uint64_t upper = m * two_over_pi_bits(first) + multiply_high(m, middle_bits) + carry;

    // Split into quarters and a signed fraction in [-1/2, 1/2].
    int quarters = static_cast<int>(upper >> 62);
    upper = upper << 2 | lower >> 62;
    lower <<= 2;
    const bool negative = upper >> 63 != 0;
    if (negative) {
        ++quarters;
        upper = ~upper;  // the complement of all bits is off by 2^-128, which is of no account
        lower = ~lower;
    }
    const DoubleDouble u = fraction(upper), l = fraction(lower);
    const DoubleDouble rest = multiply(add(u, {l.high * 0x1p-64, l.low * 0x1p-64}), HALF_PI);
    return {quarters & 3, negative ? negate(rest) : rest};
}

/// For finite angles.
QuarterTurns reduce(real angle) {
    const real size = real_abs(angle);
    if (size <= 0.78) return {0, {angle, 0}};
    if (size < 0x1p20) {
        const QuarterTurns turns = reduce_moderate(angle);
        if (real_abs(turns.rest.high) > 0x1p-20) return turns;  // else too many digits have cancelled
    }
    const QuarterTurns turns = reduce_any(size);
    return angle < 0 ? QuarterTurns{-turns.quarters & 3, negate(turns.rest)} : turns;
}

real sine_series(DoubleDouble r) {
    static constexpr real C[] = {
        -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
        -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
    const real r2 = r.high * r.high;
    return r.high + (r.high * r2 * polynomial(r2, C) + (r.low - 0.5 * r2 * r.low));
}

real cosine_series(DoubleDouble r) {
    static constexpr real C[] = {
        1.0 / 24,        -1.0 / 720,         1.0 / 40320,          -1.0 / 3628800,
        1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000, -1.0 / 6402373705728000};
    const real r2 = r.high * r.high;
    const DoubleDouble head = ordered_sum(1, -0.5 * r2);
    return head.high + (head.low + (r2 * r2 * polynomial(r2, C) - r.high * r.low));
}

/// The sine of turns + quarters * pi/2.
real sine_of(QuarterTurns turns, int quarters) {
    quarters = (turns.quarters + quarters) & 3;
    const real value = (quarters & 1) != 0 ? cosine_series(turns.rest) : sine_series(turns.rest);
    return (quarters & 2) != 0 ? -value : value;
}

// ---- Arc functions

/// arctan(j / 8) for j = 0 ... 8.
constexpr DoubleDouble ARCTAN[] = {
    {0, 0},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};

/// The angle in [0, pi/2] of the point (x, y); x, y >= 0, not both zero, and neither huge nor minute.
/// Mirrors the point to below the diagonal and turns it back by arctan c, c = j/8 nearest to y/x;
/// what is left is arctan z, |z| <= 1/16.
DoubleDouble angle_of(DoubleDouble y, DoubleDouble x) {
    const bool steep = y.high > x.high;
    const DoubleDouble a = steep ? y : x, b = steep ? x : y;

    const int j = static_cast<int>(8 * b.high / a.high + 0.5);
    const DoubleDouble c = {j * (1.0 / 8), 0};
    const DoubleDouble z = divide(add(b, negate(multiply(a, c))), add(a, multiply(b, c)));

    // arctan z = z - z^3/3 + z^5/5 - ...
    static constexpr real C[] = {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13, -1.0 / 15};
    const real z2 = z.high * z.high;
    const real tail = z.high * z2 * polynomial(z2, C);

    const DoubleDouble head = ordered_sum(ARCTAN[j].high, z.high);
    const DoubleDouble angle = ordered_sum(head.high, head.low + (ARCTAN[j].low + (z.low + tail)));
    return steep ? add(HALF_PI, negate(angle)) : angle;
}

/// sqrt(1 - x^2): the sine of an angle with cosine x, and the other way round.
DoubleDouble other_leg(real x) { return square_root(add({1, 0}, negate(product(x, x)))); }

}  // namespace

real real_exp(real x) {
    if (std::isnan(x)) return QUIET_NAN;
    return exponential({x, 0});
}

real real_log(real x) {
    if (x == 0) return -PLUS_INFINITY;
    if (!(x > 0)) return QUIET_NAN;
    if (x == PLUS_INFINITY) return PLUS_INFINITY;
    const DoubleDouble log = logarithm(x);
    return log.high + log.low;
}

real real_pow(real base, real exponent) {
    if (exponent == 0 || base == 1) return 1;
    if (std::isnan(base) || std::isnan(exponent)) return QUIET_NAN;

    const real size = real_abs(base);
    const real sign = std::signbit(base) && is_odd_integer(exponent) ? -1.0 : 1.0;
    const real limit = (size > 1) == (exponent > 0) ? PLUS_INFINITY : 0.0;  // of size^exponent, far out
    if (size == 0 || size == PLUS_INFINITY) return sign * limit;
    if (base < 0 && !is_integer(exponent)) return QUIET_NAN;
    if (size == 1) return sign;
    if (real_abs(exponent) > 0x1p64) return limit;  // such exponents are even integers
    if (real_abs(exponent) < 0x1p-64) return 1;

    return sign * exponential(multiply(logarithm(size), {exponent, 0}));
}

real real_sin(real angle) {
    if (!real_isfinite(angle)) return QUIET_NAN;
    if (real_abs(angle) < TINY) return angle;
    return sine_of(reduce(angle), 0);
}

real real_cos(real angle) {
    if (!real_isfinite(angle)) return QUIET_NAN;
    return sine_of(reduce(angle), 1);
}

real real_atan2(real y, real x) {
    if (std::isnan(x) || std::isnan(y)) return QUIET_NAN;

    real a = real_abs(x), b = real_abs(y);
    if (a == PLUS_INFINITY && b == PLUS_INFINITY) a = b = 1;  // only the direction counts
    if (b == 0) a = 1;

    DoubleDouble angle;
    const real slope = b / a;
    if (slope < TINY) {
        angle = {slope, 0};
    } else if (slope > 0x1p64) {
        angle = HALF_PI;
    } else {
        const real largest = a > b ? a : b;
        const real unit = largest > 0x1p500 ? 0x1p-600 : (largest < 0x1p-500 ? 0x1p600 : 1.0);
        angle = angle_of({b * unit, 0}, {a * unit, 0});
    }
    if (std::signbit(x)) angle = add(PI, negate(angle));
    return std::copysign(angle.high + angle.low, y);
}

real real_asin(real x) {
    const real size = real_abs(x);
    if (!(size <= 1)) return QUIET_NAN;
    if (size < TINY) return x;
    const DoubleDouble angle = angle_of({size, 0}, other_leg(x));
    return std::copysign(angle.high + angle.low, x);
}

real real_acos(real x) {
    const real size = real_abs(x);
    if (!(size <= 1)) return QUIET_NAN;
    DoubleDouble angle = angle_of(other_leg(x), {size, 0});
    if (x < 0) angle = add(PI, negate(angle));
    return angle.high + angle.low;
}

}  // namespace cyclone
