#pragma once

/// @file
/// Water: how high it stands and how it moves.
#include <cyclone/core.h>

#include <cstddef>
#include <vector>

namespace cyclone {

/// A body of water. Derive from it for a sea or a river of your own: only getHeight must be overridden, and
/// getMotion where its parts are cheaper together. Forces read it at each step, from several threads at once
/// when the World has workers, so it may change only between steps.
class CYCLONE_API Water {
public:
    /// At one point, world coordinates.
    struct Motion {
        real height = 0;       ///< of the surface, m
        Vector3 velocity;      ///< m/s
        Vector3 acceleration;  ///< m/s²
    };

    virtual ~Water() = default;

    /// World height (m) of the surface above or below a world point.
    virtual real getHeight(const Vector3 &worldPoint) const = 0;
    /// Of the water at a world point, m/s; by default it lies still.
    virtual Vector3 getVelocity(const Vector3 &worldPoint) const;
    /// Of the water at a world point, m/s²; none by default.
    virtual Vector3 getAcceleration(const Vector3 &worldPoint) const;
    /// Height, velocity and acceleration: what forces ask for.
    virtual Motion getMotion(const Vector3 &worldPoint) const;
    /// Of the surface above or below a world point, a unit vector out of the water. By default the slope is
    /// that of the heights 1 cm around.
    virtual Vector3 getNormal(const Vector3 &worldPoint) const;

protected:
    Water() = default;
    Water(const Water &) = default;
    Water &operator=(const Water &) = default;
};

namespace detail {

/// Four trains of Waves, which compilers can compute at once. Those not in use have no amplitude.
struct WaveBlock {
    static constexpr std::size_t LANES = 4;
    real amplitude[LANES] = {}, wavenumber[LANES] = {};
    real towardsX[LANES] = {}, towardsZ[LANES] = {};  ///< the direction, a unit vector
    real frequency[LANES] = {}, phase[LANES] = {};
    real phaseNow[LANES] = {};  ///< ω·t − phase, at the time set
};

}  // namespace detail

/// A sea with waves: the sum of trains of sine waves on deep water, whose speed follows from their length,
/// ω² = g·k (Airy 1845). Under a crest the water moves with the waves, in a trough against them, each
/// particle on a circle whose radius is the amplitude at the surface and decays as e^{kz} below the mean
/// level. Above the mean level velocity and acceleration are as at it.
class CYCLONE_API Waves : public Water {
public:
    /// amplitude·sin(k·s − ω·t + phase), where s runs along `direction` and k = 2π/wavelength.
    struct Train {
        real amplitude = 0;   ///< m, half the height of the waves
        real wavelength = 1;  ///< m
        real direction = 0;   ///< rad, where the waves go: from +X towards +Z
        real phase = 0;       ///< rad
    };

    /// meanHeight in m; gravity in m/s², positive.
    explicit Waves(real meanHeight = 0, real gravity = 9.81);

    /// Amplitude finite and not negative, wavelength positive, angles finite.
    void addTrain(const Train &train);
    /// The moment (s) of which all getters tell.
    void setTime(real seconds);
    real getTime() const { return time; }

    real getHeight(const Vector3 &worldPoint) const override;
    Vector3 getVelocity(const Vector3 &worldPoint) const override;
    Vector3 getAcceleration(const Vector3 &worldPoint) const override;
    Motion getMotion(const Vector3 &worldPoint) const override;
    Vector3 getNormal(const Vector3 &worldPoint) const override;

private:
    real meanHeight, gravity;
    real time = 0;
    std::size_t trainCount = 0;
    std::vector<detail::WaveBlock> blocks;
};

}  // namespace cyclone
