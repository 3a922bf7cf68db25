#pragma once

/// @file
/// Argument checking.
///
/// Constructors and setters check their arguments before they change anything. A bad one throws
/// std::invalid_argument; built without exceptions, the same text goes to stderr and the program aborts.
/// Forces are not checked: a body whose step would become non-finite keeps its state, see
/// RigidBody::integrate.
#include <cyclone/precision.h>

#include <initializer_list>
#include <stdexcept>

namespace cyclone {

/// What the library needs for itself; not for users.
namespace detail {

/// Throws: "RigidBody::setMass: the mass must be positive and finite, not -1".
[[noreturn]] CYCLONE_API void reject(const char *function, const char *rule,
                                     std::initializer_list<real> values = {});

/// Rejects the call unless its argument keeps the rule; `values` are quoted in the text.
inline void require(bool kept, const char *function, const char *rule,
                    std::initializer_list<real> values = {}) {
    if (!kept) reject(function, rule, values);
}

/// A pointer that must point to something.
template <class T>
T *requireNonNull(T *pointer, const char *function, const char *rule) {
    if (pointer == nullptr) reject(function, rule);
    return pointer;
}

}  // namespace detail
}  // namespace cyclone
