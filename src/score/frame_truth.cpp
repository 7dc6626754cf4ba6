#include "score/frame_truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <opencv2/imgproc.hpp>

#include "core/error.hpp"
#include "score/offsets.hpp"
#include "score/polyline_distance.hpp"

namespace facet {
namespace {

/// Copies the surfaces that count, numbered without gaps.
void add_surfaces(const Truth& truth, const TruthMap& map, FrameTruth& out) {
  std::vector<std::uint16_t> index(truth.surfaces.size() + 1, 0);
  std::map<int, ScoredObject> objects;
  for (std::size_t k = 0; k < truth.surfaces.size(); ++k) {
    if (!map.surface_counts[k]) continue;
    const TruthSurface& s = truth.surfaces[k];
    ScoredObject& object = objects[s.object];
    object.id = s.object;
    object.graspable = object.graspable || s.graspable;
    object.surfaces.push_back(static_cast<int>(out.scored_surfaces.size()));
    out.scored_surfaces.push_back({s.number, s.object, s.graspable, s.curved});
    out.surfaces.area_px.push_back(map.area_px[k]);
    index[k + 1] = static_cast<std::uint16_t>(out.scored_surfaces.size());
  }
  for (auto& [id, object] : objects) out.scored_objects.push_back(std::move(object));
  out.surfaces.map.resize(out.size);
  out.surface_object.resize(out.size);
  for (int y = 0; y < out.size.height; ++y) {
    for (int x = 0; x < out.size.width; ++x) {
      out.surfaces.map(x, y) = index[map.surfaces(x, y)];
      const int drawn = map.drawn(x, y);
      if (drawn > 0) out.surface_object(x, y) = static_cast<std::uint16_t>(truth.surfaces[drawn - 1u].object);
    }
  }
  out.surface_parts = connected_parts(out.surfaces.map, counted_surface_px);
}

void add_support_parts(const Image<float>& depth_m, FrameTruth& out) {
  Image<std::uint16_t> support(out.size, 0);
  for (int y = 0; y < out.size.height; ++y) {
    for (int x = 0; x < out.size.width; ++x) {
      const bool measured = depth_m.empty() || depth_m(x, y) != 0;
      support(x, y) = measured && out.regions(x, y) == TruthRegion::support ? 1 : 0;
    }
  }
  out.support_parts = connected_parts(support, counted_surface_px);
}

/// Numbers the objects of the masks without gaps, leaving out void pixels and objects of too few.
void add_objects(const Image<std::uint16_t>& masks, FrameTruth& out) {
  if (masks.empty()) return;
  out.has_masks = true;
  out.mask_object = masks;
  std::vector<int> area_px(65536, 0);
  std::vector<std::uint16_t> index(65536, 0);
  const auto value_at = [&](int x, int y) -> std::uint16_t {
    return out.regions(x, y) == TruthRegion::ignored ? 0 : masks(x, y);
  };
  for (int y = 0; y < out.size.height; ++y)
    for (int x = 0; x < out.size.width; ++x) ++area_px[value_at(x, y)];
  for (int value = 1; value < 65536; ++value) {
    const auto at = static_cast<std::size_t>(value);
    if (area_px[at] < counted_surface_px) continue;
    out.object_values.push_back(value);
    out.objects.area_px.push_back(area_px[at]);
    index[at] = static_cast<std::uint16_t>(out.object_values.size());
  }
  out.objects.map.resize(out.size);
  for (int y = 0; y < out.size.height; ++y)
    for (int x = 0; x < out.size.width; ++x) out.objects.map(x, y) = index[value_at(x, y)];
}

void add_edges(const Truth& truth, FrameTruth& out) {
  const double reach_px = std::max<double>(edge_curve_px, out.tolerance_px()) + 1;
  for (auto& distance : out.edge_distance_px)
    distance = Image<float>(out.size, std::numeric_limits<float>::infinity());
  for (const TruthEdge& edge : truth.edges) {
    const bool counts = length_px(edge.line) >= counted_edge_length_px;
    out.edges.push_back(
        {edge.number, edge.object, edge.kind, edge.graspable, counts, edge.line, sample_line(edge.line)});
    if (edge.kind == EdgeKind::none) throw Error(ErrorKind::data, "a truth edge has no kind");
    draw_distance(edge.line, reach_px, out.edge_distance_px[static_cast<std::size_t>(edge.kind) - 1]);
  }
}

void add_near_object(FrameTruth& out) {
  cv::Mat away(out.size.height, out.size.width, CV_8U);
  bool any = false;
  for (int y = 0; y < out.size.height; ++y) {
    for (int x = 0; x < out.size.width; ++x) {
      const bool object = (out.has_masks && out.mask_object(x, y) != 0) ||
                          (out.has_surfaces && out.surface_object(x, y) != 0);
      away.at<std::uint8_t>(y, x) = object ? 0 : 1;
      any = any || object;
    }
  }
  out.near_object = Image<std::uint8_t>(out.size, 0);
  if (!any) return;
  cv::Mat distance;
  cv::distanceTransform(away, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  for (int y = 0; y < out.size.height; ++y)
    for (int x = 0; x < out.size.width; ++x)
      out.near_object(x, y) = distance.at<float>(y, x) <= region_of_interest_px + 1e-3 ? 1 : 0;
}

}  // namespace

double FrameTruth::tolerance_px() const {
  return 0.0075 * std::hypot(size.width, size.height);
}

int FrameTruth::counted_edges() const {
  return static_cast<int>(
      std::count_if(edges.begin(), edges.end(), [](const ScoredEdge& e) { return e.counts; }));
}

FrameTruth frame_truth(const Truth& truth, const Image<std::uint16_t>& object_masks,
                       const Image<float>& depth_m, std::vector<TruePose> poses) {
  TruthMap map = rasterise(truth, object_masks, depth_m);
  FrameTruth out{.size = truth.size, .has_surfaces = true};
  add_surfaces(truth, map, out);
  out.regions = std::move(map.regions);
  out.poses = std::move(poses);
  add_support_parts(depth_m, out);
  add_objects(object_masks, out);
  add_edges(truth, out);
  add_near_object(out);
  return out;
}

FrameTruth frame_truth(const Image<std::uint16_t>& object_masks, const Image<float>& depth_m) {
  if (!depth_m.empty() && depth_m.size() != object_masks.size())
    throw Error(ErrorKind::data, "depth: size differs from the object masks");
  FrameTruth out{.size = object_masks.size()};
  out.regions = Image<TruthRegion>(out.size, TruthRegion::background);
  for (int y = 0; y < out.size.height; ++y) {
    for (int x = 0; x < out.size.width; ++x) {
      if (object_masks(x, y) != 0) {
        out.regions(x, y) = TruthRegion::surface;
      } else if (!depth_m.empty() && depth_m(x, y) == 0) {
        out.regions(x, y) = TruthRegion::ignored;
      }
    }
  }
  add_objects(object_masks, out);
  for (int y = 0; y < out.size.height; ++y)
    for (int x = 0; x < out.size.width; ++x)
      if (object_masks(x, y) != 0 && out.objects.map(x, y) == 0) out.regions(x, y) = TruthRegion::ignored;
  add_near_object(out);
  return out;
}

}  // namespace facet
