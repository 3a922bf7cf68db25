#include <cyclone/water.h>

#include "arguments.h"
#include "quickmath.h"

namespace cyclone {

using namespace detail;

Vector3 Water::getVelocity(const Vector3 &) const { return Vector3(); }

Vector3 Water::getAcceleration(const Vector3 &) const { return Vector3(); }

Water::Motion Water::getMotion(const Vector3 &worldPoint) const {
    return {getHeight(worldPoint), getVelocity(worldPoint), getAcceleration(worldPoint)};
}

Vector3 Water::getNormal(const Vector3 &worldPoint) const {
    const real reach = 0.01;
    const auto slopeAlong = [&](const Vector3 &axis) {
        return (getHeight(worldPoint + axis * reach) - getHeight(worldPoint - axis * reach)) / (2 * reach);
    };
    return Vector3(-slopeAlong(Vector3::X), 1, -slopeAlong(Vector3::Z)).unit();
}

Waves::Waves(real height, real g) : meanHeight(height), gravity(g) {
    requireFinite(height, "Waves::Waves", "the mean height must be finite");
    requirePositive(g, "Waves::Waves", "gravity must be positive and finite");
}

void Waves::addTrain(const Train &train) {
    requireNotNegative(train.amplitude, "Waves::addTrain", "the amplitude must be finite and not negative");
    requirePositive(train.wavelength, "Waves::addTrain", "the wavelength must be positive and finite");
    requireFinite(train.direction, "Waves::addTrain", "the direction must be finite");
    requireFinite(train.phase, "Waves::addTrain", "the phase must be finite");
    const std::size_t lane = trainCount % WaveBlock::LANES;
    if (lane == 0) blocks.emplace_back();
    ++trainCount;
    const real k = 2 * REAL_PI / train.wavelength;
    WaveBlock &block = blocks.back();
    block.amplitude[lane] = train.amplitude;
    block.wavenumber[lane] = k;
    block.towardsX[lane] = real_cos(train.direction);
    block.towardsZ[lane] = real_sin(train.direction);
    block.frequency[lane] = real_sqrt(gravity * k);
    block.phase[lane] = train.phase;
    setTime(time);
}

void Waves::setTime(real seconds) {
    requireFinite(seconds, "Waves::setTime", "the time must be finite");
    time = seconds;
    for (WaveBlock &block : blocks)
        for (std::size_t n = 0; n < WaveBlock::LANES; ++n)
            block.phaseNow[n] = block.frequency[n] * time - block.phase[n];
}

namespace {

/// Of each train at one point.
struct Phases {
    real sine[WaveBlock::LANES], cosine[WaveBlock::LANES];

    Phases(const WaveBlock &block, const Vector3 &p) {
        for (std::size_t n = 0; n < WaveBlock::LANES; ++n) {
            const real along = block.towardsX[n] * p.x + block.towardsZ[n] * p.z;
            const SineCosine phase = quickSineCosine(block.wavenumber[n] * along - block.phaseNow[n]);
            sine[n] = phase.sine;
            cosine[n] = phase.cosine;
        }
    }
};

}  // namespace

real Waves::getHeight(const Vector3 &worldPoint) const {
    real height = meanHeight;
    for (const WaveBlock &block : blocks) {
        const Phases phases(block, worldPoint);
        for (std::size_t n = 0; n < WaveBlock::LANES; ++n) height += block.amplitude[n] * phases.sine[n];
    }
    return height;
}

// Of the potential −a·ω/k·e^{kz}·cos θ, θ = k·s − ω·t + phase: the velocity is a·ω·e^{kz}·(sin θ along s,
// −cos θ up), and the acceleration, at a fixed point, −a·ω²·e^{kz}·(cos θ along s, sin θ up).
Water::Motion Waves::getMotion(const Vector3 &worldPoint) const {
    const real z = worldPoint.y - meanHeight;
    Motion sum;
    sum.height = meanHeight;
    for (const WaveBlock &block : blocks) {
        const Phases phases(block, worldPoint);
        real speed[WaveBlock::LANES];
        for (std::size_t n = 0; n < WaveBlock::LANES; ++n)
            speed[n] = block.amplitude[n] * block.frequency[n] * quickDecay(block.wavenumber[n] * z);
        for (std::size_t n = 0; n < WaveBlock::LANES; ++n) {
            const real forwards = speed[n] * phases.sine[n], upwards = -speed[n] * phases.cosine[n];
            sum.height += block.amplitude[n] * phases.sine[n];
            sum.velocity += Vector3(block.towardsX[n] * forwards, upwards, block.towardsZ[n] * forwards);
            sum.acceleration += Vector3(block.towardsX[n] * upwards, -forwards, block.towardsZ[n] * upwards) *
                                block.frequency[n];
        }
    }
    return sum;
}

Vector3 Waves::getVelocity(const Vector3 &worldPoint) const { return getMotion(worldPoint).velocity; }

Vector3 Waves::getAcceleration(const Vector3 &worldPoint) const { return getMotion(worldPoint).acceleration; }

Vector3 Waves::getNormal(const Vector3 &worldPoint) const {
    Vector3 normal = Vector3::UP;
    for (const WaveBlock &block : blocks) {
        const Phases phases(block, worldPoint);
        for (std::size_t n = 0; n < WaveBlock::LANES; ++n) {
            const real slope = block.amplitude[n] * block.wavenumber[n] * phases.cosine[n];
            normal -= Vector3(block.towardsX[n], 0, block.towardsZ[n]) * slope;
        }
    }
    return normal.unit();
}

}  // namespace cyclone
