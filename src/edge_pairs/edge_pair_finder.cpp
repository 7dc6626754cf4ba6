#include "edge_pairs/edge_pair_finder.hpp"

namespace facet {
namespace {

void draw(const std::vector<EdgeFeature>& edges, Image<std::uint8_t>& codes) {
  codes.fill(0);
  for (const EdgeFeature& edge : edges)
    for (const ContourPoint p : edge.segment.pixels)
      codes(p.x, p.y) = edge_code(edge.kind, edge.is_graspable());
}

}  // namespace

void EdgePairFinder::find(ImageView<const float> depth_m, const Camera& camera, Prediction& prediction) {
  map_.compute(params_, noise_, depth_m);
  const EdgeScene scene{map_.depth_m(), map_.depth_edges(), camera, noise_};
  const auto edges = describe_segments(params_, scene, find_segments(params_, map_.edges()));
  prediction.labels.resize(depth_m.size());
  prediction.labels.fill(0);
  prediction.edges.resize(depth_m.size());
  draw(edges, prediction.edges);
  prediction.surfaces.clear();
  prediction.rejected.clear();
  prediction.grasps = find_pairs(params_, scene, edges);
  prediction.note = prediction.grasps.empty() ? "no pair of edges can be grasped" : "it finds no regions";
}

}  // namespace facet
