#pragma once

/// @file
/// Writing things to a stream, for logs and debuggers.
///
/// Every number is as short as it can be and still read back as the same one, with a decimal point whatever
/// the locale. The stream's precision and flags are neither used nor changed; its width pads the whole.
#include <cyclone/body.h>

#include <iosfwd>

namespace cyclone {

/// `(1, -2.5, 0.1)`
CYCLONE_API std::ostream &operator<<(std::ostream &stream, const Vector3 &v);
/// `0.5-0.5i+0.5j+0.5k`
CYCLONE_API std::ostream &operator<<(std::ostream &stream, const Quaternion &q);
/// Row by row: `[1 0 0; 0 1 0; 0 0 1]`
CYCLONE_API std::ostream &operator<<(std::ostream &stream, const Matrix3 &m);
/// Row by row, without the implied row: `[1 0 0 5; 0 1 0 6; 0 0 1 7]`
CYCLONE_API std::ostream &operator<<(std::ostream &stream, const Matrix4 &m);
/// Mass, position and motion: `2.5 kg at (0, 1, 0), orientation 1+0i+0j+0k, velocity (3, 0, 0), rotation (0,
/// 0, 0), asleep`
CYCLONE_API std::ostream &operator<<(std::ostream &stream, const RigidBody &body);

}  // namespace cyclone
