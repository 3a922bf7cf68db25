#include "freerotation.h"

#include <algorithm>

#include "compiler.h"

namespace cyclone {
namespace detail {

namespace {

using Lanes = FreeRotation::Lanes;

/// tan x = numerator/denominator to x⁹ (Padé); the two are a rotation by 2x, up to a common factor, whatever
/// x is.
CYCLONE_INLINE real tangentNumerator(real x, real xx) { return x * (945 + xx * (xx - 105)); }
CYCLONE_INLINE real tangentDenominator(real xx) { return 945 + xx * (15 * xx - 420); }

/// How much the coupling of the turns, −αβ·|l|²·h², counts beside the squares of their half angles.
constexpr real COUPLING_WEIGHT = 4;

/// What one step needs between its phases.
struct Work {
    Lanes l0, l1, l2;              // angular momentum in principal axes, at the start
    Lanes turned1, turned2;        // l1 and l2 as the later turns find them
    Lanes axis1Gain, axis1Loss;    // half angle about axis 1 = l1·(gain − loss·l1²)
    Lanes axis2Gain, axis2Loss;    // half angle about axis 2 = l2·(gain − loss·l2²)
    Lanes n1, d1, n2, d2, n3, d3;  // tangents of the three half angles, as fractions
    Lanes r, i, j, k;              // the step's rotation, of any length
    Lanes squaredLength;           // of that; known before the rotation itself
    Lanes squaredMomentum;         // |l|²
    Lanes squaredAngle;            // sum of the squares of all half angles, and of the turns' coupling
};

/// l = Rᵀ·L
CYCLONE_INLINE void momentumToPrincipalAxes(const FreeRotation &b, Work &w, int lanes) {
    for (int n = 0; n < lanes; ++n) {
        const real r = b.orientation[0][n], i = b.orientation[1][n], j = b.orientation[2][n],
                   k = b.orientation[3][n];
        const real x = b.momentum[0][n], y = b.momentum[1][n], z = b.momentum[2][n];
        const real tx = 2 * (y * k - z * j), ty = 2 * (z * i - x * k), tz = 2 * (x * j - y * i);
        w.l0[n] = x + r * tx + (ty * k - tz * j);
        w.l1[n] = y + r * ty + (tz * i - tx * k);
        w.l2[n] = z + r * tz + (tx * j - ty * i);
    }
}

/// The angles' corrections, from the two constants of the motion, |l|² and the energy above i0·|l|²/2.
CYCLONE_INLINE void correctAngles(const FreeRotation &b, Work &w, int lanes, real h) {
    const real hh = h * h;
    for (int n = 0; n < lanes; ++n) {
        const real alpha = b.inverseInertia[1][n] - b.inverseInertia[0][n];
        const real beta = b.inverseInertia[2][n] - b.inverseInertia[0][n];
        const real x = b.momentum[0][n], y = b.momentum[1][n], z = b.momentum[2][n];
        const real square = x * x + y * y + z * z;
        const real both = alpha * beta * square * hh;
        const real angle1 = alpha * (h * 0.25), angle2 = beta * (h * 0.5);
        const real common = (alpha - 2 * beta) * (hh / 6);
        const real energy = alpha * w.l1[n] * w.l1[n] + beta * w.l2[n] * w.l2[n];
        w.squaredMomentum[n] = square;
        w.squaredAngle[n] = -COUPLING_WEIGHT * both;
        w.axis1Gain[n] = angle1 * (1 + both * (1.0 / 12)) - angle1 * common * energy;
        w.axis1Loss[n] = angle1 * (alpha * (3 * beta - alpha) * (hh / 6));
        w.axis2Gain[n] = angle2 * (1 - both * (1.0 / 6)) - angle2 * common * energy;
        w.axis2Loss[n] = angle2 * (beta * (2 * beta - 3 * alpha) * (hh / 6));
    }
}

/// Half a turn about axis 1, one about axis 2, half a turn about axis 1.
CYCLONE_INLINE void turnAboutAxes(Work &w, int lanes) {
    for (int n = 0; n < lanes; ++n) {
        const real l0 = w.l0[n], l1 = w.l1[n], l2 = w.l2[n];
        const real u1 = l1 * (w.axis1Gain[n] - w.axis1Loss[n] * l1 * l1), uu1 = u1 * u1;
        const real n1 = tangentNumerator(u1, uu1), d1 = tangentDenominator(uu1);
        const real square1 = n1 * n1 + d1 * d1, scale1 = 1 / square1;
        const real c1 = d1 * d1 - n1 * n1, s1 = 2 * n1 * d1;
        const real lx = (c1 * l0 - s1 * l2) * scale1;
        const real lz = (c1 * l2 + s1 * l0) * scale1;

        const real u2 = lz * (w.axis2Gain[n] - w.axis2Loss[n] * lz * lz), uu2 = u2 * u2;
        const real n2 = tangentNumerator(u2, uu2), d2 = tangentDenominator(uu2);
        const real square2 = n2 * n2 + d2 * d2, scale2 = 1 / square2;
        const real c2 = d2 * d2 - n2 * n2, s2 = 2 * n2 * d2;
        const real ly = (c2 * l1 - s2 * lx) * scale2;

        const real u3 = ly * (w.axis1Gain[n] - w.axis1Loss[n] * ly * ly), uu3 = u3 * u3;
        const real n3 = tangentNumerator(u3, uu3), d3 = tangentDenominator(uu3);
        w.n1[n] = n1, w.d1[n] = d1;
        w.n2[n] = n2, w.d2[n] = d2;
        w.n3[n] = n3, w.d3[n] = d3;
        w.squaredLength[n] = square1 * square2 * (n3 * n3 + d3 * d3);
        w.turned1[n] = ly, w.turned2[n] = lz;
        w.squaredAngle[n] += uu1 + uu2 + uu3;
    }
}

/// The turn about l as a quaternion, times the three turns about the axes.
CYCLONE_INLINE void composeTurns(const FreeRotation &b, Work &w, int lanes, real h) {
    for (int n = 0; n < lanes; ++n) {
        const real i0 = b.inverseInertia[0][n];
        const real alpha = b.inverseInertia[1][n] - i0, beta = b.inverseInertia[2][n] - i0;
        const real l1 = w.l1[n], ly = w.turned1[n], lz = w.turned2[n];
        const real rate =
            i0 + alpha * beta * (h * h / 12) * (alpha * 0.5 * (l1 * l1 + ly * ly) - 2 * beta * (lz * lz));
        const real angle = h * 0.5 * rate;  // half of it, for each unit of l
        const real fx = w.l0[n] * angle, fy = l1 * angle, fz = w.l2[n] * angle;
        const real ff = angle * angle * w.squaredMomentum[n];
        const real sine = tangentNumerator(1, ff), cosine = tangentDenominator(ff);
        w.squaredLength[n] *= cosine * cosine + sine * sine * ff;
        w.squaredAngle[n] += ff;

        // (cosine, sine·f)·(d1, 0, n1, 0)
        const real ai = fx * sine, aj = fy * sine, ak = fz * sine, n1 = w.n1[n], d1 = w.d1[n];
        const real br = cosine * d1 - aj * n1, bi = ai * d1 - ak * n1, bj = aj * d1 + cosine * n1,
                   bk = ak * d1 + ai * n1;
        // ·(d2, 0, 0, n2)
        const real n2 = w.n2[n], d2 = w.d2[n];
        const real cr = br * d2 - bk * n2, ci = bi * d2 + bj * n2, cj = bj * d2 - bi * n2,
                   ck = bk * d2 + br * n2;
        // ·(d3, 0, n3, 0)
        const real n3 = w.n3[n], d3 = w.d3[n];
        w.r[n] = cr * d3 - cj * n3;
        w.i[n] = ci * d3 - ck * n3;
        w.j[n] = cj * d3 + cr * n3;
        w.k[n] = ck * d3 + ci * n3;
    }
}

/// Normalised by the product of the lengths, so as not to wait for the product itself.
CYCLONE_INLINE void turnOrientation(FreeRotation &b, const Work &w, int lanes) {
    for (int n = 0; n < lanes; ++n) {
        const real r = b.orientation[0][n], i = b.orientation[1][n], j = b.orientation[2][n],
                   k = b.orientation[3][n];
        const real sr = w.r[n], si = w.i[n], sj = w.j[n], sk = w.k[n];
        const real scale = 1 / real_sqrt((r * r + i * i + j * j + k * k) * w.squaredLength[n]);
        b.orientation[0][n] = (r * sr - i * si - j * sj - k * sk) * scale;
        b.orientation[1][n] = (r * si + i * sr + j * sk - k * sj) * scale;
        b.orientation[2][n] = (r * sj + j * sr + k * si - i * sk) * scale;
        b.orientation[3][n] = (r * sk + k * sr + i * sj - j * si) * scale;
    }
}

/// R, the matrix of the orientation.
CYCLONE_INLINE void updateMatrix(FreeRotation &b, int lanes) {
    for (int n = 0; n < lanes; ++n) {
        const real r = b.orientation[0][n], i = b.orientation[1][n], j = b.orientation[2][n],
                   k = b.orientation[3][n];
        const real ii = 2 * i * i, jj = 2 * j * j, kk = 2 * k * k, ij = 2 * i * j, ik = 2 * i * k,
                   jk = 2 * j * k, ri = 2 * r * i, rj = 2 * r * j, rk = 2 * r * k;
        b.matrix[0][0][n] = 1 - (jj + kk), b.matrix[0][1][n] = ij - rk, b.matrix[0][2][n] = ik + rj;
        b.matrix[1][0][n] = ij + rk, b.matrix[1][1][n] = 1 - (ii + kk), b.matrix[1][2][n] = jk - ri;
        b.matrix[2][0][n] = ik - rj, b.matrix[2][1][n] = jk + ri, b.matrix[2][2][n] = 1 - (ii + jj);
    }
}

/// R·diag(i0, i1, i2)·Rᵀ·L; R is that of the principal axes.
CYCLONE_INLINE void updateRotation(FreeRotation &b, int lanes) {
    for (int n = 0; n < lanes; ++n) {
        const real xx = b.matrix[0][0][n], xy = b.matrix[0][1][n], xz = b.matrix[0][2][n];
        const real yx = b.matrix[1][0][n], yy = b.matrix[1][1][n], yz = b.matrix[1][2][n];
        const real zx = b.matrix[2][0][n], zy = b.matrix[2][1][n], zz = b.matrix[2][2][n];
        const real x = b.finalMomentum[0][n], y = b.finalMomentum[1][n], z = b.finalMomentum[2][n];
        const real w0 = b.inverseInertia[0][n] * (xx * x + yx * y + zx * z);
        const real w1 = b.inverseInertia[1][n] * (xy * x + yy * y + zy * z);
        const real w2 = b.inverseInertia[2][n] * (xz * x + yz * y + zz * z);
        b.rotation[0][n] = xx * w0 + xy * w1 + xz * w2;
        b.rotation[1][n] = yx * w0 + yy * w1 + yz * w2;
        b.rotation[2][n] = zx * w0 + zy * w1 + zz * w2;
    }
}

/// From the orientations of turned bodies to those of their principal axes, or back (sign −1).
CYCLONE_INLINE void turnByAxes(FreeRotation &b, int lanes, real sign) {
    for (int n = 0; n < lanes; ++n) {
        const real r = b.orientation[0][n], i = b.orientation[1][n], j = b.orientation[2][n],
                   k = b.orientation[3][n];
        const real pr = b.principalAxes[0][n], pi = sign * b.principalAxes[1][n],
                   pj = sign * b.principalAxes[2][n], pk = sign * b.principalAxes[3][n];
        const bool turned = b.isTurned[n] > 0;
        const real qr = r * pr - i * pi - j * pj - k * pk, qi = r * pi + i * pr + j * pk - k * pj,
                   qj = r * pj + j * pr + k * pi - i * pk, qk = r * pk + k * pr + i * pj - j * pi;
        b.orientation[0][n] = turned ? qr : r;
        b.orientation[1][n] = turned ? qi : i;
        b.orientation[2][n] = turned ? qj : j;
        b.orientation[3][n] = turned ? qk : k;
    }
}

/// The rotation of one step, as a quaternion of any length, and the measure of its angles.
CYCLONE_INLINE void computeTurns(const FreeRotation &b, Work &w, int lanes, real h) {
    momentumToPrincipalAxes(b, w, lanes);
    correctAngles(b, w, lanes, h);
    turnAboutAxes(w, lanes);
    composeTurns(b, w, lanes, h);
}

void copyLane(const FreeRotation &from, int fromLane, FreeRotation &to, int toLane) {
    for (int n = 0; n < 3; ++n) to.inverseInertia[n][toLane] = from.inverseInertia[n][fromLane];
    for (int n = 0; n < 3; ++n) to.momentum[n][toLane] = from.momentum[n][fromLane];
    for (int n = 0; n < 4; ++n) to.orientation[n][toLane] = from.orientation[n][fromLane];
}

constexpr int MAX_SUBSTEPS = 256;
constexpr real MAX_SUBSTEP_ANGLE = 0.7;       // rad
constexpr real LARGEST_SQUARED_ANGLE = 0.25;  // beyond it the method's error grows fast

/// What the error of a step grows with, rad/s, as a bound over the whole motion: the angular velocities of
/// its turns, and how fast one turn changes the next, √(−αβ)·|l|. The turn about axis 1 stays below the
/// bound since |l|² and α·l1² + β·l2² are constant: (α·l1)² ≤ α²·l1² − αβ·|l|²; likewise about axis 2.
real boundOfRates(const FreeRotation &b, Work &w) {
    momentumToPrincipalAxes(b, w, 1);
    const real i0 = b.inverseInertia[0][0];
    const real alpha = b.inverseInertia[1][0] - i0, beta = b.inverseInertia[2][0] - i0;
    const real l1 = w.l1[0], l2 = w.l2[0], square = w.l0[0] * w.l0[0] + l1 * l1 + l2 * l2;
    return real_sqrt((i0 * i0 - 4 * COUPLING_WEIGHT * alpha * beta) * square + alpha * alpha * l1 * l1 +
                     beta * beta * l2 * l2);
}

/// The slow path for large rotations: the step in 2, 4 … 256 parts.
void advanceInSubsteps(FreeRotation &block, int lane, real h) {
    FreeRotation one;
    Work work;
    copyLane(block, lane, one, 0);
    const real bound = boundOfRates(one, work);
    int substeps = 2;
    while (substeps < MAX_SUBSTEPS && bound * h > substeps * MAX_SUBSTEP_ANGLE) substeps *= 2;
    real duration = h / substeps;
    if (bound * duration > MAX_SUBSTEP_ANGLE) duration = MAX_SUBSTEP_ANGLE / bound;

    for (int n = 0; n < substeps; ++n) {
        computeTurns(one, work, 1, duration);
        turnOrientation(one, work, 1);
    }
    copyLane(one, 0, block, lane);
}

CYCLONE_INLINE void advanceLanes(FreeRotation &block, int lanes, real h) {
    Work work;
    if (block.areAnyTurned) turnByAxes(block, lanes, 1);
    computeTurns(block, work, lanes, h);

    real before[4][FreeRotation::LANES];
    for (int part = 0; part < 4; ++part)
        for (int n = 0; n < lanes; ++n) before[part][n] = block.orientation[part][n];
    turnOrientation(block, work, lanes);
    for (int n = 0; n < lanes; ++n) {
        if (work.squaredAngle[n] <= LARGEST_SQUARED_ANGLE) continue;
        for (int part = 0; part < 4; ++part) block.orientation[part][n] = before[part][n];
        advanceInSubsteps(block, n, h);
    }
    updateMatrix(block, lanes);
    updateRotation(block, lanes);
    if (!block.areAnyTurned) return;
    turnByAxes(block, lanes, -1);
    updateMatrix(block, lanes);
}

/// Those of bodies that are not turned, so that all lanes can be computed alike.
void fillOtherAxes(FreeRotation &block, int lanes) {
    for (int n = 0; n < lanes; ++n)
        if (block.isTurned[n] == 0)
            for (int part = 0; part < 4; ++part) block.principalAxes[part][n] = part == 0 ? 1 : 0;
}

CYCLONE_TARGET_CLONES void advanceBlock(FreeRotation &block, real h) {
    advanceLanes(block, FreeRotation::LANES, h);
}

}  // namespace

void FreeRotation::advance(int lanes, real duration) {
    if (areAnyTurned) fillOtherAxes(*this, lanes);
    if (lanes == LANES)
        advanceBlock(*this, duration);
    else if (lanes == 1)
        advanceLanes(*this, 1, duration);
    else
        advanceLanes(*this, lanes, duration);
}

}  // namespace detail
}  // namespace cyclone
