#include "base/random.h"

namespace demo {

Wind::Wind(const Vector3 &m, real gustiness, real memory, real step, std::uint64_t seed)
    : random(seed), mean(m), windspeed(m), kept(cyclone::real_exp(-step / memory)) {
    // A random number between -1 and 1 has the variance 1/3. Two averages in a row leave the share
    // (1 − k)⁴·(1 + k²)/(1 − k²)³ of it.
    const real lost = 1 - kept, share = lost * lost * lost * lost * (1 + kept * kept) /
                                        ((1 - kept * kept) * (1 - kept * kept) * (1 - kept * kept));
    amplitude = gustiness / cyclone::real_sqrt(share / 3);
}

void Wind::advance() {
    const real x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    first = first * kept + Vector3(x, y / 2, z) * (amplitude * (1 - kept));
    second = second * kept + first * (1 - kept);
    windspeed = mean + second;
}

}  // namespace demo
