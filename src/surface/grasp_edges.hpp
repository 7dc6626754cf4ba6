#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/image_view.hpp"
#include "surface/surface.hpp"
#include "surface/vec2.hpp"

namespace facet {

/// A straight piece of a surface's outline where a finger can reach [px], on the border between the surface's
/// pixels and those around. The surface lies on the side left_of(to - from).
struct StraightEdge {
  Vec2 from, to;
};

/// Straight pieces of the graspable part of outlines. An outline pixel is graspable if it is an edge pixel
/// labelled so, or has one beside it: depth edges count for the surface that they are part of, which is the
/// nearer one; creases for both sides. Keeps its memory from surface to surface.
class GraspableEdges {
 public:
  /// Pieces in the order of the outline, none of its pixels farther than `tolerance_px` from its piece: split
  /// at the pixel farthest from the chord (Douglas and Peucker 1973, as in Kovesi's lineseg), joined again
  /// where one line serves both, and fitted by least squares. The view stays valid until the next call.
  const std::vector<StraightEdge>& find(const Surface& surface, ImageView<const std::uint16_t> labels,
                                        ImageView<const std::uint8_t> edges, double tolerance_px);

  /// The graspable pixels of that outline, in order, shortest gaps closed.
  const std::vector<Vec2>& pixels() const { return points_; }

 private:
  using Range = std::pair<std::size_t, std::size_t>;  ///< of points_, both ends included

  void collect(const Polyline& outline);
  void add_run(const Polyline& outline, std::size_t first, std::size_t count);
  void split(Range range);
  void join();
  StraightEdge fit(Range range) const;
  bool is_straight(Range range) const;
  std::size_t farthest_from_chord(Range range) const;

  double tolerance_px_ = 0;
  std::vector<std::uint8_t> graspable_;  ///< per outline pixel
  std::vector<Vec2> points_;
  std::vector<Range> runs_, ranges_;
  std::vector<StraightEdge> edges_;
};

}  // namespace facet
