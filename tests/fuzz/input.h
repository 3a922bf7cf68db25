#pragma once

/// What a fuzz target reads its arguments from, and how it says that something does not hold.
#include <cyclone/core.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace cyclone_fuzz {

using cyclone::Matrix3;
using cyclone::Quaternion;
using cyclone::real;
using cyclone::Vector3;

/// The bytes of one run, taken from front to back; zeros after the end.
class Input {
public:
    Input(const std::uint8_t *bytes, std::size_t count) : next(bytes), end(bytes + count) {}

    bool isAtEnd() const { return next == end; }
    std::uint8_t byte() { return next < end ? *next++ : std::uint8_t(0); }
    unsigned below(unsigned count) { return byte() % count; }
    bool flag() { return byte() % 2 == 1; }

    /// A small number, or the next eight bytes as they are: any double, NaN and infinity among them.
    real number() {
        const std::uint8_t kind = byte();
        if (kind < 192) return (kind - 96) / 16.0;
        std::uint64_t bits = 0;
        for (int n = 0; n < 8; ++n) bits |= std::uint64_t(byte()) << (8 * n);
        real value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    }
    real duration() { return flag() ? number() : 1.0 / 60; }
    Vector3 vector() {
        const real x = number(), y = number(), z = number();
        return Vector3(x, y, z);
    }
    Quaternion quaternion() {
        const Vector3 v = vector();
        return Quaternion(number(), v.x, v.y, v.z);
    }
    /// Any numbers; or symmetric ones; or diagonal ones.
    Matrix3 matrix() {
        const unsigned kind = below(3);
        const Vector3 diagonal = vector();
        Matrix3 result;
        result.setDiagonal(diagonal.x, diagonal.y, diagonal.z);
        if (kind == 2) return result;
        const Vector3 upper = vector(), lower = kind == 0 ? vector() : upper;
        result.data[1] = upper.x, result.data[2] = upper.y, result.data[5] = upper.z;
        result.data[3] = lower.x, result.data[6] = lower.y, result.data[7] = lower.z;
        return result;
    }

private:
    const std::uint8_t *next, *end;
};

inline void expect(bool holds, const char *what) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

}  // namespace cyclone_fuzz
