#pragma once

/// @file
/// In and out of the types, axes and units of a host: a game engine, a renderer, a mathematics library.
///
///     body.setVelocity(vectorFrom(hostVelocity));
///     actor.setRotation(toHost<HostQuaternion>(body.getOrientation()));
///
/// A host whose axes or units differ needs an AxisConvention as well:
///
///     const AxisConvention unreal = AxisConvention::unreal();
///     actor->SetActorLocation(toHost<FVector>(unreal.getPointInHost(body.getPosition())));
///     body.addForce(unreal.getVectorInCyclone(vectorFrom(hostForce)));
///
/// Matrices for graphics: Matrix4::fillGLArray gives sixteen floats or doubles, column by column, for hosts
/// that multiply columns (OpenGL, Vulkan, glm). Hosts that multiply rows from the left and store row by row
/// (Direct3D's XMMATRIX, Unreal's FMatrix) have the same sixteen numbers in the same order. Godot's
/// Transform3D takes getAxisVector 0 to 3 as its columns.
#include <cyclone/core.h>

#include <type_traits>
#include <utility>

namespace cyclone {

namespace detail {

/// How a host's type spells its components: `x y z w` (most), `X Y Z W` (Unreal), or else by index.
template <class Host, class = void>
struct HasLowercaseMembers : std::false_type {};
template <class Host>
struct HasLowercaseMembers<Host, std::void_t<decltype(std::declval<Host &>().x)>> : std::true_type {};
template <class Host, class = void>
struct HasUppercaseMembers : std::false_type {};
template <class Host>
struct HasUppercaseMembers<Host, std::void_t<decltype(std::declval<Host &>().X)>> : std::true_type {};

/// Component 0, 1, 2 or 3: x, y, z or w.
template <int INDEX, class Host>
decltype(auto) component(Host &host) {
    static_assert(INDEX >= 0 && INDEX < 4, "x, y, z or w");
    if constexpr (HasLowercaseMembers<Host>::value) {
        if constexpr (INDEX == 0) return (host.x);
        if constexpr (INDEX == 1) return (host.y);
        if constexpr (INDEX == 2) return (host.z);
        if constexpr (INDEX == 3) return (host.w);
    } else if constexpr (HasUppercaseMembers<Host>::value) {
        if constexpr (INDEX == 0) return (host.X);
        if constexpr (INDEX == 1) return (host.Y);
        if constexpr (INDEX == 2) return (host.Z);
        if constexpr (INDEX == 3) return (host.W);
    } else {
        return (host[INDEX]);
    }
}

/// The host's number type, such as float.
template <class Host>
using HostNumber = std::decay_t<decltype(component<0>(std::declval<Host &>()))>;

}  // namespace detail

/// Of any host's vector, array or the like.
template <class Host>
Vector3 vectorFrom(const Host &host) {
    return Vector3(static_cast<real>(detail::component<0>(host)),
                   static_cast<real>(detail::component<1>(host)),
                   static_cast<real>(detail::component<2>(host)));
}

/// Of any host's quaternion with members x, y, z and w, the real part.
template <class Host>
Quaternion quaternionFrom(const Host &host) {
    return Quaternion(
        static_cast<real>(detail::component<3>(host)), static_cast<real>(detail::component<0>(host)),
        static_cast<real>(detail::component<1>(host)), static_cast<real>(detail::component<2>(host)));
}

/// For any host's vector that can be made as Host{x, y, z}.
template <class Host>
Host toHost(const Vector3 &v) {
    using Number = detail::HostNumber<Host>;
    return Host{static_cast<Number>(v.x), static_cast<Number>(v.y), static_cast<Number>(v.z)};
}

/// For any host's quaternion with members x, y, z and w. (Constructors differ in where they want the real
/// part, so the members are set by name.)
template <class Host>
Host toHost(const Quaternion &q) {
    using Number = detail::HostNumber<Host>;
    Host result{};
    detail::component<0>(result) = static_cast<Number>(q.i);
    detail::component<1>(result) = static_cast<Number>(q.j);
    detail::component<2>(result) = static_cast<Number>(q.k);
    detail::component<3>(result) = static_cast<Number>(q.r);
    return result;
}

/// The inverse of Matrix4::fillGLArray; the implied row of the array is not looked at.
template <class Number>
Matrix4 matrixFromGLArray(const Number *array) {
    Matrix4 result;
    for (unsigned column = 0; column < 4; ++column)
        result.setAxisVector(column, vectorFrom(array + 4 * column));
    return result;
}

/// A host's axes, unit of length and origin. The default is Cyclone's own: right-handed, X forward, Y up, Z
/// to the right, metres.
///
/// Handedness is taken care of, provided that rotations, torques and orientations are converted by their own
/// functions.
class CYCLONE_API AxisConvention {
public:
    AxisConvention() = default;
    /// Cyclone's X, Y and Z in the host's axes: unit vectors at right angles. Host units in a metre,
    /// positive.
    AxisConvention(const Vector3 &forward, const Vector3 &up, const Vector3 &right, real unitsPerMetre = 1);

    static AxisConvention unreal();  ///< left-handed, X forward, Z up, Y right, centimetres
    static AxisConvention unity();   ///< left-handed, Z forward, Y up, X right, metres
    static AxisConvention godot();   ///< right-handed, −Z forward, Y up, X right, metres

    /// The point of Cyclone's world, m, that is the host's origin: for hosts that keep it near the camera,
    /// where floats are precise. Zero by default.
    void setOrigin(const Vector3 &worldPoint);
    Vector3 getOrigin() const { return origin; }

    Vector3 getPointInHost(const Vector3 &point) const { return getVectorInHost(point - origin); }
    Vector3 getPointInCyclone(const Vector3 &hostPoint) const {
        return getVectorInCyclone(hostPoint) + origin;
    }

    /// Quantities with the dimension of a length: offsets, velocities, accelerations, forces.
    Vector3 getVectorInHost(const Vector3 &vector) const { return axes * vector * unitsPerMetre; }
    Vector3 getVectorInCyclone(const Vector3 &hostVector) const {
        return axes.transformTranspose(hostVector) * (1 / unitsPerMetre);
    }

    /// Axes and normals: the length stays.
    Vector3 getDirectionInHost(const Vector3 &direction) const { return axes * direction; }
    Vector3 getDirectionInCyclone(const Vector3 &hostDirection) const {
        return axes.transformTranspose(hostDirection);
    }

    /// Angular velocity, rad/s. (A torque takes unitsPerMetre² besides.)
    Vector3 getRotationInHost(const Vector3 &rotation) const { return axes * rotation * handedness; }
    Vector3 getRotationInCyclone(const Vector3 &hostRotation) const {
        return axes.transformTranspose(hostRotation) * handedness;
    }

    /// From the host's body axes to its world axes.
    Quaternion getOrientationInHost(const Quaternion &orientation) const;
    Quaternion getOrientationInCyclone(const Quaternion &hostOrientation) const;

    /// Takes points in the host's body axes to points in its world, all in its units.
    Matrix4 getTransformInHost(const Matrix4 &transform) const;

private:
    Matrix3 axes = Matrix3(1, 0, 0, 0, 1, 0, 0, 0, 1);  ///< from Cyclone's to the host's
    real handedness = 1;                                ///< −1: left-handed
    real unitsPerMetre = 1;
    Vector3 origin;
};

}  // namespace cyclone
