#pragma once

/// @file
/// The number type of the library, and its elementary functions.
///
/// Same input, same bits: every function here uses only + - * / sqrt and integer operations in a
/// fixed order and never calls the C library's exp, pow, sin and the like, which differ from one
/// machine to the next. Compile with -ffp-contract=off, lest a compiler fuse a * b + c into one rounding.
/// Rounding to nearest and subnormal numbers, the processor's defaults, are assumed (no FTZ or DAZ).
#include <cyclone/export.h>

#include <cfloat>
#include <cmath>
#include <limits>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(_M_FP_FAST)
#error "Cyclone needs exact IEEE arithmetic: compile it without -ffast-math, -Ofast and their kin."
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "Cyclone detects NaN and infinity: compile it without -ffinite-math-only."
#endif

/// The whole library.
namespace cyclone {

/// The type of every scalar: an IEEE double.
using real = double;

static_assert(std::numeric_limits<real>::is_iec559, "Cyclone needs IEEE 754 doubles.");
static_assert(
    FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 16,  // 16 concerns half precision only
    "Cyclone needs doubles without excess precision: on 32-bit x86, compile with -msse2 -mfpmath=sse.");

/// The largest finite number.
inline constexpr real REAL_MAX = DBL_MAX;

/// The distance from 1 to the next larger number, 2^-52.
inline constexpr real REAL_EPSILON = DBL_EPSILON;

inline constexpr real REAL_PI = 3.14159265358979323846;  ///< π

/// Correctly rounded, as IEEE demands; NaN below zero.
inline real real_sqrt(real x) { return std::sqrt(x); }

inline real real_abs(real x) { return std::fabs(x); }

/// False for NaN and for both infinities.
inline bool real_isfinite(real x) { return real_abs(x) <= REAL_MAX; }

/// The number in [low, high] closest to x; NaN stays NaN.
inline real real_clamp(real x, real low, real high) { return x < low ? low : (x > high ? high : x); }

// The functions below are accurate to better than one ulp (unit in the last place) over their whole
// range, subnormal results and huge angles included. Special values are those of C99, Annex F;
// every NaN that they return is the same quiet NaN.

/// e to the power x. Overflows to infinity above 709.78, underflows to zero below -745.13.
CYCLONE_API real real_exp(real x);

/// Natural logarithm. Minus infinity at zero, NaN below.
CYCLONE_API real real_log(real x);

/// base to the power exponent. A negative base needs an integer exponent, else NaN.
/// Anything to the power 0, and 1 to the power of anything, is 1: even of NaN.
CYCLONE_API real real_pow(real base, real exponent);

/// Sine of an angle in radians, of any size; NaN if it is infinite.
CYCLONE_API real real_sin(real angle);

/// Cosine of an angle in radians, of any size; NaN if it is infinite.
CYCLONE_API real real_cos(real angle);

/// The angle in [-pi, pi] of the point (x, y), from the x axis towards the y axis.
/// Signed zeros choose the side of the cut: (-0, -1) lies at -pi.
CYCLONE_API real real_atan2(real y, real x);

/// The angle in [-pi/2, pi/2] whose sine is x; NaN outside [-1, 1].
CYCLONE_API real real_asin(real x);

/// The angle in [0, pi] whose cosine is x; NaN outside [-1, 1].
CYCLONE_API real real_acos(real x);

}  // namespace cyclone
