#pragma once

/// @file
/// Errors: a clear word, and nothing lost.
///
/// Constructors and setters check their arguments before they change anything. A bad one ends in
/// std::invalid_argument; built without exceptions, the same text goes to stderr and the program aborts.
/// Forces are not checked: a body whose step would become non-finite keeps its state, see
/// RigidBody::integrate.
#include <cyclone/precision.h>

#include <initializer_list>
#include <stdexcept>

namespace cyclone {

/// Refuses a call: "RigidBody::setMass: the mass must be positive and finite, not -1".
[[noreturn]] CYCLONE_API void refuse(const char *function, const char *rule,
                                     std::initializer_list<real> values = {});

/// Refuses the call unless its argument keeps the rule; `values` are quoted in the text.
inline void require(bool kept, const char *function, const char *rule,
                    std::initializer_list<real> values = {}) {
    if (!kept) refuse(function, rule, values);
}

/// A pointer that must point to something.
template <class T>
T *requireNonNull(T *pointer, const char *function, const char *rule) {
    if (pointer == nullptr) refuse(function, rule);
    return pointer;
}

}  // namespace cyclone
