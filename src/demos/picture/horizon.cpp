#include "picture/horizon.h"

#include <algorithm>
#include <cmath>

namespace demo {

namespace {

constexpr Colour HEAVEN{84, 150, 222}, EARTH{132, 92, 52}, LINE{250, 250, 250}, WINGS{255, 214, 64};
constexpr real FIELD_OF_VIEW = cyclone::REAL_PI / 3;  // rad, from the lower edge to the upper

/// Two wings with a gap for the nose between them, which is a dot.
bool isWing(int fromMiddle, int width) {
    const int distance = std::abs(fromMiddle);
    return distance == 0 || (distance > width / 8 && distance <= width / 3);
}

}  // namespace

Image paintHorizon(int width, int height, const Attitude &attitude) {
    Image image{width, height, {}};
    const int middleX = width / 2, middleY = height / 2;
    const real sine = std::sin(attitude.bank), cosine = std::cos(attitude.bank);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            // How far above the horizon this pixel looks, in pixels.
            const real above =
                attitude.pitch * height / FIELD_OF_VIEW - (x - middleX) * sine - (y - middleY) * cosine;
            Colour colour = mix(EARTH, HEAVEN, std::clamp(above + 0.5, 0.0, 1.0));
            colour = mix(colour, LINE, std::clamp(1 - std::fabs(above), 0.0, 1.0));
            if (y == middleY && isWing(x - middleX, width)) colour = WINGS;
            image.pixels.push_back(colour);
        }
    }
    return image;
}

}  // namespace demo
