#pragma once

namespace facet {

/// Above every crease strength: stands where it is not known.
inline constexpr float unknown_strength = 9.0f;

}  // namespace facet
