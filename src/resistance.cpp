#include <cyclone/force.h>

#include <algorithm>
#include <utility>

namespace cyclone {

// ---- What generators tell

void Resistance::add(const Matrix3 &tensor, const Vector3 &arm, bool rotationalFlow) {
    Matrix3 cross;
    cross.setSkewSymmetric(arm);  // cross·v = arm × v
    const Matrix3 torque = cross * tensor;
    forceByVelocity += tensor;
    torqueByVelocity += torque;
    if (!rotationalFlow) return;
    const Matrix3 fromRotation = cross.transpose();  // the point's velocity is rotation × arm
    forceByRotation += tensor * fromRotation;
    torqueByRotation += torque * fromRotation;
}

void ForceGenerator::addResistance(const RigidBody &, Resistance &) const {}

namespace {

// ---- Six by six

struct Vector6 {
    real data[6] = {};

    Vector6() = default;
    Vector6(const Vector3 &a, const Vector3 &b) : data{a.x, a.y, a.z, b.x, b.y, b.z} {}

    Vector3 first() const { return Vector3(data[0], data[1], data[2]); }
    Vector3 second() const { return Vector3(data[3], data[4], data[5]); }
    real squareMagnitude() const { return first().squareMagnitude() + second().squareMagnitude(); }
};

Vector6 operator+(const Vector6 &a, const Vector6 &b) {
    return Vector6(a.first() + b.first(), a.second() + b.second());
}
Vector6 operator*(const Vector6 &a, real scale) { return Vector6(a.first() * scale, a.second() * scale); }
Vector6 operator-(const Vector6 &a, const Vector6 &b) { return a + b * -1; }

struct Matrix6 {
    real data[6][6] = {};

    void setBlock(int row, int column, const Matrix3 &block) {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) data[row + i][column + j] = block.data[3 * i + j];
    }
    /// The greatest sum of a row's sizes; NaN if any entry is not a number.
    real norm() const {
        real greatest = 0;
        for (const auto &row : data) {
            real sum = 0;
            for (const real entry : row) sum += real_abs(entry);
            if (!(sum <= greatest)) greatest = sum;
        }
        return greatest;
    }
};

Vector6 operator*(const Matrix6 &m, const Vector6 &v) {
    Vector6 result;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) result.data[i] += m.data[i][j] * v.data[j];
    return result;
}

Matrix6 operator*(const Matrix6 &a, const Matrix6 &b) {
    Matrix6 result;
    for (int i = 0; i < 6; ++i)
        for (int k = 0; k < 6; ++k)
            for (int j = 0; j < 6; ++j) result.data[i][j] += a.data[i][k] * b.data[k][j];
    return result;
}

Matrix6 operator*(const Matrix6 &m, real scale) {
    Matrix6 result = m;
    for (auto &row : result.data)
        for (real &entry : row) entry *= scale;
    return result;
}

/// The solution x of m·x = v: elimination with the largest pivots. Not finite where m is singular.
Vector6 solve(Matrix6 m, Vector6 v) {
    for (int column = 0; column < 6; ++column) {
        int pivot = column;
        for (int row = column + 1; row < 6; ++row)
            if (real_abs(m.data[row][column]) > real_abs(m.data[pivot][column])) pivot = row;
        std::swap(m.data[column], m.data[pivot]);
        std::swap(v.data[column], v.data[pivot]);
        for (int row = column + 1; row < 6; ++row) {
            const real factor = m.data[row][column] / m.data[column][column];
            for (int k = column; k < 6; ++k) m.data[row][k] -= factor * m.data[column][k];
            v.data[row] -= factor * v.data[column];
        }
    }
    for (int row = 5; row >= 0; --row) {
        for (int k = row + 1; k < 6; ++k) v.data[row] -= m.data[row][k] * v.data[k];
        v.data[row] /= m.data[row][row];
    }
    return v;
}

/// The greatest size of an eigenvalue, by |m^16|^(1/16) (Gelfand): exact for diagonal matrices, a few per
/// cent too much for others.
real spectralRadius(Matrix6 m) {
    real sizes[5];
    for (real &size : sizes) {
        size = m.norm();
        if (size == 0) return 0;
        m = m * (1 / size);
        m = m * m;
    }
    real radius = 1;
    for (int n = 4; n >= 0; --n) radius = sizes[n] * real_sqrt(radius);
    return radius;
}

// ---- The implicit kick

/// Beyond this, rounding in the elimination would drown what does not resist.
constexpr real LARGEST_STIFFNESS = 1e12;

/// K = (1 + γB)⁻¹, of which an implicit step is made.
class Decay {
public:
    explicit Decay(const Matrix6 &b) : size(b.norm()), matrix(b * GAMMA) {
        for (int n = 0; n < 6; ++n) matrix.data[n][n] += 1;
    }
    /// No more than twice as long as v, and shorter where B does nothing but resist. A B that feeds motion as
    /// fast as a step can follow, or is too large for the arithmetic, is taken for a resistance of its size
    /// in all directions.
    Vector6 operator*(const Vector6 &v) const {
        if (size <= LARGEST_STIFFNESS) {
            const Vector6 result = solve(matrix, v);
            if (result.squareMagnitude() <= 4 * v.squareMagnitude()) return result;
        }
        return v * (1 / (1 + size * GAMMA));
    }
    /// (1 − R)·B⁻¹·v, with R as resist() has it.
    Vector6 kick(const Vector6 &v) const {
        const Vector6 once = *this * v, twice = *this * once, thrice = *this * twice;
        return (once + twice + thrice * (1 - ROOT_3)) * GAMMA;
    }

private:
    static constexpr real ROOT_3 = 1.7320508075688772, GAMMA = (3 + ROOT_3) / 6;

    real size;
    Matrix6 matrix;
};

/// Coordinates in which linear and angular momentum weigh alike, and a resistance that is symmetric stays so:
/// force along world axes and torque along principal axes, divided by √mass and √moment. A locked direction
/// or axis has neither.
class Scale {
public:
    Scale(const Vector3 &inverseRootMass, const Matrix3 &principalAxes, const Vector3 &inverseMoments)
        : axes(principalAxes),
          factors(inverseRootMass, Vector3(real_sqrt(inverseMoments.x), real_sqrt(inverseMoments.y),
                                           real_sqrt(inverseMoments.z))) {}

    Vector6 scaled(const Wrench &wrench) const {
        Vector6 result(wrench.force, axes.transformTranspose(wrench.torque));
        for (int n = 0; n < 6; ++n) result.data[n] *= factors.data[n];
        return result;
    }
    Wrench unscaled(const Vector6 &v) const {
        Vector6 result;
        for (int n = 0; n < 6; ++n) result.data[n] = factors.data[n] > 0 ? v.data[n] / factors.data[n] : 0;
        return {result.first(), axes * result.second()};
    }
    /// Scaled by the step's length as well, and positive where it resists.
    Matrix6 scaled(const Resistance &resistance, real duration) const {
        const Matrix3 toAxes = axes.transpose();
        Matrix6 b;
        b.setBlock(0, 0, resistance.forceByVelocity);
        b.setBlock(0, 3, resistance.forceByRotation * axes);
        b.setBlock(3, 0, toAxes * resistance.torqueByVelocity);
        b.setBlock(3, 3, toAxes * resistance.torqueByRotation * axes);
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j) b.data[i][j] *= -duration * factors.data[i] * factors.data[j];
        return b;
    }

private:
    Matrix3 axes;
    Vector6 factors;
};

Vector6 between(const Vector6 &a, const Vector6 &b, real prop) { return a * (1 - prop) + b * prop; }

}  // namespace

/// With the motion u at half steps, c the time from the last one to this, l the longer of c and the step h,
/// B = −l·∂a/∂u its resistance and a(u) the acceleration, the explicit step adds to u
///
///     Δ = c·a(u) + h·a_added
///
/// and this one (1 − R)·B⁻¹·Δ, with R = √3·K² − (√3 − 1)·K³, K = (1 + γB)⁻¹ and γ = (3 + √3)/6: u decays to
/// the terminal motion by R a step, which agrees with e^−B to second order and is positive for whatever B
/// resists. u is the reported motion less the last step's closing kick d, and a(u) = a + B·d/l. Of the
/// acceleration a only K³·a stays one of generators, with a closing kick of its own, which then never turns
/// the reported motion round; the rest is added plainly. Along directions in which B is 0 all of this is the
/// explicit step. Damping makes c differ between velocity and rotation; B would mix what is
/// left over, and so there is one for both.
void RigidBody::resist(const Resistance &sum, real duration) {
    if (!hasFiniteMass()) return;
    if (lockedMotion != 0) dropLockedForces();
    const real rootMass = real_sqrt(mass);
    const Scale scale(possible(Vector3(1, 1, 1) * (1 / rootMass)), getPrincipalAxesInWorld(), inverseInertia);
    const real acting = actingTime(duration), length = std::max(acting, duration);
    const Matrix6 b = scale.scaled(sum, length);
    const real stiffness = spectralRadius(b);
    if (!(stiffness > EXPLICIT_LIMIT)) return;

    const Vector6 constant(acceleration * rootMass, Vector3());
    const Vector6 acts = scale.scaled(generated) + constant, plain = scale.scaled(added);
    const Vector6 closingKick =
        scale.scaled({memory.acceleration * (mass * memory.linearKick), memory.torque * memory.angularKick});
    const Decay decay(b);
    const Vector6 kick = decay.kick((acts + b * closingKick * (1 / length)) * acting + plain * duration);
    const Vector6 lasting = decay * (decay * (decay * acts));
    const Vector6 rest = (kick - lasting * acting) * (1 / duration);

    const real blend = std::min<real>(stiffness / EXPLICIT_LIMIT - 1, 1);
    generated = scale.unscaled(between(acts, lasting, blend) - constant);
    added = scale.unscaled(between(plain, rest, blend));
    hasAdded = hasGenerated = true;
}

}  // namespace cyclone
