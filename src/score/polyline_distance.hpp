#pragma once

#include "core/image.hpp"
#include "core/image_point.hpp"

namespace facet {

/// Points at the arc lengths 0, 1, 2, ... px of an open line, as far as it goes.
ImagePath sample_line(const ImagePath& line);

/// Distance of a point to the nearest point of an open line [px]; infinite for an empty line.
double distance_px(ImagePoint point, const ImagePath& line);

/// Lowers every pixel of `distance` (distance of its centre to lines drawn before [px]) to the distance to
/// `line` where that is smaller. Pixels farther than `reach_px` may keep what they had.
void draw_distance(const ImagePath& line, double reach_px, Image<float>& distance);

}  // namespace facet
