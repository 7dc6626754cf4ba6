#pragma once

#include "synth/layout.hpp"

namespace facet {

/// Scenes made for one measurement each. The camera stands where the recipe would put it, with `distance_m`.

/// Three ridges whose faces meet at `crease_deg`, turned differently.
Layout crease_layout(double crease_deg, double distance_m, std::uint64_t seed, std::uint64_t index);
/// Two pairs of boxes with a gap of `gap_mm` between them, across and along the line of sight.
Layout gap_layout(double gap_mm, double distance_m, std::uint64_t seed, std::uint64_t index);
/// Strips 3, 5, 8 and 12 mm wide, 120 mm long and 20 mm high, at random places and angles.
Layout strip_layout(double distance_m, std::uint64_t seed, std::uint64_t index);

}  // namespace facet
