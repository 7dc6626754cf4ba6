#pragma once

#include "overlay/panel.hpp"

namespace facet {

/// Colour of an edge code on the panel and in its legend.
cv::Scalar edge_color(std::uint8_t code);

/// Edges by kind on the dimmed frame: depth red, convex green, concave blue; those that a finger could grasp
/// are bright and thick. A prediction without edges shows the frame alone.
cv::Mat draw_edges(const Frame& frame, const Prediction& prediction);

}  // namespace facet
