#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/camera.hpp"
#include "core/depth_noise.hpp"
#include "core/image_view.hpp"
#include "surface/grasp_clearance.hpp"
#include "surface/grasp_edges.hpp"
#include "surface/grasp_wrench.hpp"
#include "surface/plane_frame.hpp"
#include "surface/pose.hpp"

namespace facet {

/// A gripper with two parallel fingers, and what it needs to hold.
struct GraspParams {
  bool enabled = true;
  float friction = 0.5f;           ///< Coulomb coefficient, 0..10: rubber on cardboard or wood
  float finger_width_mm = 15.0f;   ///< least overlap of two edges, and room needed outside them, 1..1000
  float max_opening_mm = 100.0f;   ///< of the jaw, 0..10000
  float min_opening_mm = 5.0f;     ///< narrower surfaces are as narrow as the noise of their edges, 0..10000
  float line_tolerance_px = 2.0f;  ///< an edge bends less than this along its straight pieces, 0..100
  float min_edge_px = 8.0f;        ///< shorter pieces have no sure direction, 0..1000
  float clearance_mm = 5.0f;       ///< what stands out of the plane by more blocks a finger, 0..1000
  int most_per_surface = 3;        ///< the best ones are kept, 1..100
};

/// What grasps are computed from.
struct GraspInput {
  ImageView<const float> depth_m;  ///< filtered depth
  ImageView<const std::uint16_t> labels;
  ImageView<const std::uint8_t> edges;  ///< codes, see EdgeKind
  Camera camera;
  DepthNoise noise;
  std::uint64_t seed = 0;
};

/// Finds planar force-closure grasps on surfaces, after Jabalameli and Behal, Robotics 8(3):63, 2019: pairs
/// of straight graspable edges of one surface that face each other, overlap by the width of a finger, can be
/// squeezed without slipping and are free for the fingers. Keeps its memory from surface to surface.
class GraspFinder {
 public:
  /// Fills surface.grasps, best first; score = overlap of the edges [m] times the cosine of the angle between
  /// them, ties to the pair that comes first along the outline. Surfaces without pose or outline have none.
  ///
  /// Edges and contacts lie in the surface's plane. A curved surface is taken by its outline, in the plane of
  /// its graspable outline pixels, or across the line of sight where they lie in none. The grasp stands
  /// where the fingers are free, on the overlap of the edges and as near as possible to the surface's centre,
  /// so that its weight twists the grasp least.
  void find(const GraspInput& input, const GraspParams& params, Surface& surface);

 private:
  /// A straight edge in the plane of the grasp [m].
  struct Side {
    Vec2 from, to, inward;
  };
  /// Two sides that can be squeezed wherever they overlap: along `axis`, across the closing direction, the
  /// fingers' middle may stand from `low` to `high`.
  struct Pair {
    Side a, b;
    Vec2 axis;
    double low = 0, high = 0;
    double score = 0;
  };
  Plane plane_of_outline(const GraspInput& input, const GraspParams& params, const Surface& surface);
  void collect_sides(const PlaneFrame& frame, const GraspParams& params,
                     const std::vector<StraightEdge>& edges);
  static std::optional<Pair> pair(const GraspParams& params, const Side& a, const Side& b);
  /// Where the line through `axis` coordinate `at` along the closing direction meets a side.
  static PlanarContact contact_at(const Side& side, Vec2 axis, double at);
  static std::optional<Grasp> place(const GraspClearance& clearance, const GraspParams& params,
                                    const Pair& pair);

  GraspableEdges edges_;
  PointSample outline_;
  std::vector<Side> sides_;
  std::vector<Pair> pairs_;
};

}  // namespace facet
