#pragma once

/// An artificial horizon: how an aircraft lies, as its pilot sees it.
#include "picture/canvas.h"

namespace demo {

/// rad: nose up and bank to starboard are positive.
struct Attitude {
    real pitch = 0, bank = 0;
};

/// Sky above and earth below a white line that tilts and sinks as the horizon does behind a windscreen, 60°
/// from the lower edge to the upper; and in the middle, where the nose points, the aircraft's wings.
Image paintHorizon(int width, int height, const Attitude &attitude);

}  // namespace demo
