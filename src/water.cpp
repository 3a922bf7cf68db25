#include <cyclone/water.h>

#include "arguments.h"
#include "compiler.h"
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

/// Sine and cosine of each train's θ = k·s − ω·t + phase, and its e^{kz}.
struct WaveTerms {
    real sine[WaveBlock::LANES], cosine[WaveBlock::LANES], decay[WaveBlock::LANES];
};

/// z is the height above the mean level. The last loop is without branches, for compilers to do all trains at
/// once.
CYCLONE_TARGET_CLONES void evaluate(const WaveBlock &block, const Vector3 &point, real z, WaveTerms &terms) {
    real angle[WaveBlock::LANES], exponent[WaveBlock::LANES];
    for (std::size_t n = 0; n < WaveBlock::LANES; ++n) {
        const real along = block.towardsX[n] * point.x + block.towardsZ[n] * point.z;
        angle[n] = real_clamp(block.wavenumber[n] * along - block.phaseNow[n], -0x1p49, 0x1p49);
        exponent[n] = real_clamp(block.wavenumber[n] * z, -40, 0);
    }
    for (std::size_t n = 0; n < WaveBlock::LANES; ++n) {
        const SineCosine theta = quickSineCosine(angle[n]);
        terms.sine[n] = theta.sine;
        terms.cosine[n] = theta.cosine;
    }
    for (std::size_t n = 0; n < WaveBlock::LANES; ++n) terms.decay[n] = quickDecay(exponent[n]);
}

}  // namespace

real Waves::getHeight(const Vector3 &worldPoint) const {
    WaveTerms terms;
    real height = meanHeight;
    for (const WaveBlock &block : blocks) {
        evaluate(block, worldPoint, 0, terms);
        for (std::size_t n = 0; n < WaveBlock::LANES; ++n) height += block.amplitude[n] * terms.sine[n];
    }
    return height;
}

// Of the potential −a·ω/k·e^{kz}·cos θ, θ = k·s − ω·t + phase: the velocity is a·ω·e^{kz}·(sin θ along s,
// −cos θ up), and the acceleration, at a fixed point, −a·ω²·e^{kz}·(cos θ along s, sin θ up).
Water::Motion Waves::getMotion(const Vector3 &worldPoint) const {
    WaveTerms terms;
    real height = meanHeight;
    Vector3 velocity, acceleration;
    for (const WaveBlock &block : blocks) {
        evaluate(block, worldPoint, worldPoint.y - meanHeight, terms);
        for (std::size_t n = 0; n < WaveBlock::LANES; ++n) {
            const real speed = block.amplitude[n] * block.frequency[n] * terms.decay[n];
            const real forwards = speed * terms.sine[n], upwards = -speed * terms.cosine[n];
            const Vector3 towards(block.towardsX[n], 0, block.towardsZ[n]);
            height += block.amplitude[n] * terms.sine[n];
            velocity += towards * forwards + Vector3::UP * upwards;
            acceleration += (towards * upwards - Vector3::UP * forwards) * block.frequency[n];
        }
    }
    return {height, velocity, acceleration};
}

Vector3 Waves::getVelocity(const Vector3 &worldPoint) const { return getMotion(worldPoint).velocity; }

Vector3 Waves::getAcceleration(const Vector3 &worldPoint) const { return getMotion(worldPoint).acceleration; }

Vector3 Waves::getNormal(const Vector3 &worldPoint) const {
    WaveTerms terms;
    Vector3 normal = Vector3::UP;
    for (const WaveBlock &block : blocks) {
        evaluate(block, worldPoint, 0, terms);
        for (std::size_t n = 0; n < WaveBlock::LANES; ++n) {
            const real slope = block.amplitude[n] * block.wavenumber[n] * terms.cosine[n];
            normal -= Vector3(block.towardsX[n], 0, block.towardsZ[n]) * slope;
        }
    }
    return normal.unit();
}

}  // namespace cyclone
