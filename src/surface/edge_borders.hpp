#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/image_view.hpp"
#include "surface/surface.hpp"

namespace facet {

/// A border between a component of set pixels and one of those around or inside it.
struct EdgeBorder {
  ContourPoint start;    ///< the set pixel from which it was followed
  bool is_hole = false;  ///< of a hole of the component, at the right of `start`; otherwise the outer border
  int parent = -1;       ///< border next outside, in the order of their discovery; -1 = none
  std::size_t begin = 0, end = 0;  ///< its points
};

/// All borders of a mask's 8-connected components and their nesting: Suzuki and Abe 1985, as
/// cv::findContours follows them with RETR_TREE and CHAIN_APPROX_NONE, point for point. Keeps its memory.
class EdgeBorders {
 public:
  /// `mask`: zeros and ones; beyond the image there is nothing.
  void follow(ImageView<const std::uint8_t> mask);

  std::span<const EdgeBorder> borders() const { return borders_; }  ///< in order of discovery, raster order
  std::span<const ContourPoint> points(const EdgeBorder& border) const {
    return {points_.data() + border.begin, points_.data() + border.end};
  }

 private:
  void find_neighbours(ImageView<const std::uint8_t> mask);
  void scan_row(int y);
  /// The borders that begin at the left and at the right end of a run of set pixels.
  void visit_left_end(int pixel, int before);
  void visit_right_end(int pixel, int left_end);
  void follow_border(int start, bool is_hole, int parent);
  int place(int x, int y) const { return (y + 1) * pitch_ + x + 1; }

  int width_ = 0, pitch_ = 0;
  std::vector<std::uint8_t> set_;         ///< the mask with nothing around it
  std::vector<std::uint8_t> neighbours_;  ///< bit i: the neighbour in direction i is set
  std::vector<std::int32_t> marks_;  ///< number of a border there, from 1 on; negative left of a clear pixel
  std::vector<EdgeBorder> borders_;
  std::vector<ContourPoint> points_;
};

}  // namespace facet
