#pragma once

#include "surface/surface.hpp"

namespace facet {

/// The pixels of an outline that are corners of its convex hull, in the outline's order and as often as there
/// (Andrew 1979, on the topmost and the lowest pixel of every column). OpenCV begins a hull by the order of
/// its points, so what it makes of these is what it makes of the whole outline, to the bit.
Polyline convex_corners(const Polyline& outline);

}  // namespace facet
