#pragma once

/// @file
/// The free rotation of rigid bodies: what happens to an orientation while no torque acts.
///
/// Euler's equations are advanced by a splitting that keeps angular momentum exactly and is of fourth order
/// in the step. Let the axes be principal, numbered cyclically so that axis 0 has the middle inertia, and let
/// i0, i1, i2 be the inverse moments, l the angular momentum in these axes. With α = i1 − i0 and β = i2 − i0
/// the kinetic energy is
///
///     i0·|l|²/2  +  α·l1²/2  +  β·l2²/2 .
///
/// The first part alone turns the body about l, and commutes with the others; the second and third alone turn
/// it about axis 1 and axis 2. So a step is that rotation, and Strang's product of half a turn about axis 1,
/// one about axis 2 and half a turn about axis 1 (McLachlan & Quispel 2002). Energy and |l| being constant,
/// the h² error of the product is itself a motion about the same axes, and is cancelled by slightly changed
/// angles: no further evaluation, no sine or cosine. Spheres and symmetric tops come out exact.
#include <cyclone/core.h>

namespace cyclone {
namespace detail {

/// Some bodies side by side, one number of each in every array, so that compilers vectorise the plain loops
/// over them. Every lane is computed alone: the same operations in the same order, whatever the other lanes
/// hold. For speed nothing is set at first: fill the lanes that advance() is to work on.
struct CYCLONE_API FreeRotation {
    static constexpr int LANES = 16;  ///< more than one vector, so that one is computed while another waits

    using Lanes = real[LANES];

    // In: all in axes numbered so that axis 0 is the one of the middle inertia.
    Lanes inverseInertia[3];  ///< principal, 1/(kg·m²)
    Lanes momentum[3];        ///< angular momentum during the step, world, kg·m²/s
    Lanes finalMomentum[3];   ///< angular momentum after the step's last kick, world

    // In, where there are turned bodies: such as have principal axes that are not their own.
    bool areAnyTurned = false;
    Lanes isTurned;          ///< 1, or 0 for the others
    Lanes principalAxes[4];  ///< of turned ones: r, i, j, k; from principal axes to body axes, unit

    // In and out.
    Lanes orientation[4];  ///< r, i, j, k; from body axes to world, unit

    // Out.
    Lanes matrix[3][3];  ///< of the new orientation
    Lanes rotation[3];   ///< angular velocity that belongs to finalMomentum, world, rad/s

    /// Advances the first `lanes` bodies (1 … LANES) by `duration` seconds. A body that turns by more than
    /// about 1 rad, or tumbles fast for its shape, is advanced in up to 256 shorter steps; what would need
    /// more turns less far.
    void advance(int lanes, real duration);
};

}  // namespace detail
}  // namespace cyclone
