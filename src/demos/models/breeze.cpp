#include "models/breeze.h"

namespace demo {

namespace {

constexpr real REFERENCE_HEIGHT = 10;  // m
constexpr real GUSTS_OF_WIND = 0.1;    // MIL-F-8785C: the vertical gusts' root mean square over the wind

}  // namespace

Breeze::Breeze(const Vector3 &windFrom, real gusts, std::uint64_t seed)
    : gradient(-windFrom, REFERENCE_HEIGHT), turbulence(gusts / GUSTS_OF_WIND, seed) {}

}  // namespace demo
