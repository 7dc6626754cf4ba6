#pragma once

#include <cstdint>
#include <vector>

#include "core/image_view.hpp"

namespace facet {

/// The border between two labels: pairs of neighbouring pixels, by the kind of the edge between them.
struct SurfaceBorder {
  int a = 0, b = 0;  ///< labels, a < b
  int depth_px = 0, convex_px = 0, concave_px = 0;
  int a_nearer_px = 0, b_nearer_px = 0;  ///< of the depth edges, by the side that they stand on
  int next = -1;                         ///< index of the next border with the same a, -1 = none

  int crease_px() const { return convex_px + concave_px; }
  int length_px() const { return crease_px() + depth_px; }
};

/// Every border between two labels of a label map, in order of appearance. Keeps its memory between frames.
class SurfaceBorders {
 public:
  /// labels: 0 = none, at most `label_count`; edges: codes of core/edge_code.hpp. A pair of neighbours has
  /// the kind of the edge on or beside it, depth before crease; pairs without any are left out.
  void collect(ImageView<const std::uint16_t> labels, ImageView<const std::uint8_t> edges, int label_count);
  const std::vector<SurfaceBorder>& all() const { return borders_; }

 private:
  SurfaceBorder& between(int label, int other);

  std::vector<SurfaceBorder> borders_;
  std::vector<int> first_, latest_;  ///< indices of borders, by a; -1 = none
};

}  // namespace facet
