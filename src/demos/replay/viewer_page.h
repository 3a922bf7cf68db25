#pragma once

/// The viewer, viewer.html with its style and its scripts in it, in two pieces: the recording belongs between
/// them. The build makes the pieces with embed.cmake.
#include <string_view>

namespace demo {

extern const std::string_view viewerPageHead, viewerPageTail;

}  // namespace demo
