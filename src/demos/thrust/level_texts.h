#pragma once

/// The files of levels/, as the build embeds them.
#include <string_view>
#include <vector>

namespace thrust {

extern const std::vector<std::string_view> levelTexts;

}  // namespace thrust
