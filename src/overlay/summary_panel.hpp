#pragma once

#include <string>
#include <vector>

#include "overlay/panel.hpp"

namespace facet {

/// What there is to say about a frame in a few lines: size, depth, numbers of surfaces, edges and dropped
/// regions.
std::vector<std::string> summary_lines(const Frame& frame, const Prediction& prediction);

/// Those lines as a panel of the frame's panel size.
cv::Mat draw_summary(const Frame& frame, const Prediction& prediction);

}  // namespace facet
