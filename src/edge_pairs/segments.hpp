#pragma once

#include <cstdint>
#include <vector>

#include "core/image_view.hpp"
#include "edge_pairs/edge_pair_params.hpp"
#include "surface/surface.hpp"
#include "surface/vec2.hpp"

namespace facet {

/// A straight piece of edge.
struct Segment {
  Vec2 from, to;    ///< [px]
  Polyline pixels;  ///< of the edge map that it stands for
};

/// Step 4: the lines of an edge map, one pixel wide, linked from pixel to pixel between their ends and
/// junctions, split at the pixel farthest from the chord (Douglas and Peucker 1973, as in Kovesi's lineseg),
/// short pieces dropped, collinear neighbours merged.
std::vector<Segment> find_segments(const EdgePairParams& params, ImageView<const std::uint8_t> edges);

}  // namespace facet
