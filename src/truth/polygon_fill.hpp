#pragma once

#include <functional>

#include "core/image_point.hpp"
#include "core/image_view.hpp"

namespace facet {

/// Calls `visit(y, x0, x1)` for the pixels x0 <= x < x1 of every row whose centres lie inside the polygon by
/// the even-odd rule; points on a left or top border are inside, on a right or bottom border outside. Clipped
/// to `size`.
void for_each_span(const ImagePath& polygon, Size size,
                   const std::function<void(int y, int x0, int x1)>& visit);

}  // namespace facet
