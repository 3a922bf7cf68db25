#pragma once

/// @file
/// Wind that differs from place to place.
///
/// A field's velocity is the way the air goes, m/s in world coordinates: the opposite sign of the `windspeed`
/// of the aerodynamic surfaces, which points to where the wind comes from.
#include <cyclone/core.h>

namespace cyclone {

/// Air in motion. Derive from it for a wind of your own. Generators read it at each frame, from several
/// threads at once if the World has workers, so it must not change itself when it is read.
class CYCLONE_API WindField {
public:
    virtual ~WindField() = default;
    /// Where the air at a world point goes, m/s, world coordinates.
    virtual Vector3 getVelocity(const Vector3 &worldPoint) const = 0;

protected:
    WindField() = default;
    WindField(const WindField &) = default;
    WindField &operator=(const WindField &) = default;
};

}  // namespace cyclone
