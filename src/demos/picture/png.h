#pragma once

/// Pictures as PNG files.
#include "picture/canvas.h"

#include <iosfwd>

namespace demo {

/// Writes a picture as PNG (8-bit RGB, ISO/IEC 15948); the stream's state says whether it could be written.
void writePng(std::ostream &out, const Image &image);

}  // namespace demo
