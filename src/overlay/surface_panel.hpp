#pragma once

#include <map>

#include "overlay/panel.hpp"

namespace facet {

/// Surfaces in their colours over the grey frame, with white lines between them and the id of each that has
/// room for it.
cv::Mat draw_surfaces(const Frame& frame, const Prediction& prediction,
                      const std::map<int, cv::Scalar>& colors);

}  // namespace facet
