#pragma once

#include <optional>
#include <string>
#include <vector>

#include "synth/quickstart.hpp"
#include "synth/render.hpp"
#include "synth/true_edges.hpp"

namespace facet {

/// A face of an object as far as it is seen.
struct TrueFace {
  std::uint16_t surface_id = 0, object_id = 0;
  std::string name{};  ///< "box, top"
  bool curved = false;
  bool graspable = false;  ///< two of its graspable edges oppose each other
  int visible_px = 0;
  double occluded_share = 0;     ///< of the pixels it would have if its object stood alone, 0..1
  std::optional<Plane> plane{};  ///< flat faces; camera frame
  Vec3 centroid_m{};             ///< mean of the visible points, camera frame
};

/// Truth of a view, from its geometry.
struct SceneTruth {
  std::vector<TrueFace> faces{};  ///< with at least one visible pixel, by surface id
  std::vector<TrueEdge> edges{};
};

/// Void rules of the scores: smaller faces and shorter edges are not counted.
inline constexpr int counted_face_px = 100;
inline constexpr double counted_edge_px = 12;

/// Numbers of graspable objects, faces and edges that count: what the paper's Table 2 lists.
struct GraspCounts {
  int objects = 0, surfaces = 0, edges = 0;
  friend bool operator==(const GraspCounts&, const GraspCounts&) = default;
};

/// The faces that `exact` shows; `edges` are those of the view and decide what is graspable. Without
/// occluded_share.
std::vector<TrueFace> true_faces(const Scene& scene, const PosedScene& posed, const Rendering& exact,
                                 const Camera& camera, const std::vector<TrueEdge>& edges);
/// Faces and edges of what `exact` shows; without occluded_share, which needs add_occlusion().
SceneTruth scene_truth(const View& view, const PosedScene& posed, const Rendering& exact,
                       const Camera& camera, const EdgeWalk& walk = {});
/// Sets occluded_share by rendering every object alone.
void add_occlusion(SceneTruth& truth, const View& view, const Camera& camera, Size size);
/// `factor` scales both limits of the void rules.
GraspCounts grasp_counts(const SceneTruth& truth, double factor = 1);

}  // namespace facet
