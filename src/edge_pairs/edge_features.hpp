#pragma once

#include <optional>
#include <vector>

#include "core/camera.hpp"
#include "core/depth_noise.hpp"
#include "edge_pairs/segments.hpp"

namespace facet {

/// What the edges are seen in.
struct EdgeScene {
  ImageView<const float> depth_m;  ///< smoothed
  ImageView<const std::uint8_t> depth_edges;
  Camera camera;
  DepthNoise noise;
};

/// What one side of a segment looks like.
struct EdgeSide {
  float depth_m = 0;  ///< median
  Vec3 centre_m;      ///< mean of its points
  std::optional<Plane> plane;
};

/// Step 5: what a segment is.
struct EdgeFeature {
  Segment segment;
  EdgeKind kind = EdgeKind::none;
  EdgeSide left, right;         ///< left is the side left_of(to - from)
  bool left_reachable = false;  ///< whether a finger that takes the surface on that side has room beside it
  bool right_reachable = false;

  bool is_graspable() const { return left_reachable || right_reachable; }
};

/// The segments that are edges. A step in depth between the sides makes a depth edge, which belongs to the
/// nearer side; otherwise the angle between the planes on both sides makes it convex, so that either side may
/// be taken, or concave, which no finger reaches. Segments without depth on a side, or with one plane through
/// both, are none. Nothing nearer than a side may stand within the width of a finger beyond its edge.
std::vector<EdgeFeature> describe_segments(const EdgePairParams& params, const EdgeScene& scene,
                                           const std::vector<Segment>& segments);

}  // namespace facet
