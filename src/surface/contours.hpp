#pragma once

#include <cstdint>
#include <vector>

#include "core/image_view.hpp"
#include "surface/edge_borders.hpp"
#include "surface/surface.hpp"

namespace facet {

enum class ContourMode {
  regions,   ///< outline of every label of the label map: closed whatever the edges do
  edge_map,  ///< the paper: borders of the edge image; a surface is a hole of the edge network
};

struct ContourParams {
  ContourMode mode = ContourMode::regions;
};

/// Outlines of the labels 1 ... surfaces.size() of `labels` (0 = none), into surfaces[label - 1]: contour,
/// parent and children. Of a label in several parts the outer contour is that of the part with the largest
/// bounding box, which no other part encloses; holes are those of all parts. Suzuki and Abe 1985 by way of
/// cv::findContours, one label at a time, so touching surfaces each have an outline of their own.
/// `boxes[label - 1]` bounds the label's pixels.
struct PixelBox {
  int x0 = 0, y0 = 0, x1 = -1, y1 = -1;  ///< inclusive

  void add(int x, int y);
  bool empty() const { return x1 < x0; }
};
void trace_regions(ImageView<const std::uint16_t> labels, const std::vector<PixelBox>& boxes,
                   std::vector<Surface>& surfaces);

/// The paper's contour separation (section 4.2.3): the borders of the edge map with their hierarchy. A
/// surface is a hole of the edge network; its outline runs on the edge pixels that it
/// shares with its neighbours. Surfaces that no closed contour bounds (open towards the image border) keep an
/// empty contour.
void trace_edge_map(const EdgeBorders& edge_borders, ImageView<const std::uint16_t> labels,
                    std::vector<Surface>& surfaces);

}  // namespace facet
