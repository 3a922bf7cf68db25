#pragma once

/// Sky, ground and sea: what fills the picture before anything is drawn onto it.
#include "picture/camera.h"
#include "picture/raster.h"

namespace demo {

/// Fills the raster. Grid lines on ground and sea lie 10 m apart (every tenth is stronger) through the
/// world's origin; each pixel shows the mean of what it covers, so that nothing flickers towards the horizon.
/// The waves travel as in deep water, ω² = g·k. Space is dark all over. An eye below the surface sees as from
/// just above it. `sun` is the unit vector towards it.
void paintBackdrop(Raster &raster, const View &view, const Surroundings &surroundings, real time,
                   const Vector3 &sun);

}  // namespace demo
