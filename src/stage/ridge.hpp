#pragma once

#include <cstdint>

namespace facet {

/// What non-maximum suppression leaves of a pixel, for hysteresis to decide on.
enum class Ridge : std::uint8_t { none = 0, weak = 1, strong = 2 };

}  // namespace facet
