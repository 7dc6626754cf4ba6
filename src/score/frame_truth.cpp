#include "score/frame_truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <opencv2/imgproc.hpp>
#include <set>

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
      support(x, y) = measured && out.surfaces.regions(x, y) == TruthRegion::support ? 1 : 0;
    }
  }
  out.support_parts = connected_parts(support, counted_surface_px);
}

/// Numbers the objects without gaps, leaving out those of too few pixels. `objects.regions` must be known.
void add_objects(const Image<std::uint16_t>& values, FrameTruth& out) {
  std::vector<int> area_px(65536, 0);
  std::vector<std::uint16_t> index(65536, 0);
  Image<TruthRegion>& regions = out.objects.regions;
  for (int y = 0; y < out.size.height; ++y)
    for (int x = 0; x < out.size.width; ++x)
      if (regions(x, y) != TruthRegion::ignored) ++area_px[values(x, y)];
  for (std::size_t value = 1; value < index.size(); ++value) {
    if (area_px[value] < counted_surface_px) continue;
    out.object_values.push_back(static_cast<int>(value));
    out.objects.area_px.push_back(area_px[value]);
    index[value] = static_cast<std::uint16_t>(out.object_values.size());
  }
  out.objects.map = Image<std::uint16_t>(out.size, 0);
  for (int y = 0; y < out.size.height; ++y) {
    for (int x = 0; x < out.size.width; ++x) {
      if (values(x, y) == 0 || regions(x, y) == TruthRegion::ignored) continue;
      out.objects.map(x, y) = index[values(x, y)];
      regions(x, y) = index[values(x, y)] > 0 ? TruthRegion::surface : TruthRegion::ignored;
    }
  }
  out.objects.outlines = region_outlines(out.objects.map, out.objects.size(), regions);
}

/// The object of every surface that counts.
Image<std::uint16_t> objects_of_surfaces(const FrameTruth& frame) {
  Image<std::uint16_t> values(frame.size, 0);
  for (int y = 0; y < frame.size.height; ++y)
    for (int x = 0; x < frame.size.width; ++x)
      if (frame.surfaces.map(x, y) != 0) values(x, y) = frame.surface_object(x, y);
  return values;
}

/// Notes which surfaces of its object the edge bounds.
void add_bounded_surfaces(const FrameTruth& frame, ScoredEdge& edge) {
  const std::vector<GridOffset> around = offsets_within(neighbourhood_px + 1);
  std::map<int, int> samples_near;  // per surface
  for (const ImagePoint s : edge.samples) {
    std::set<int> near;
    const int cx = static_cast<int>(std::lround(s.x)), cy = static_cast<int>(std::lround(s.y));
    for (const GridOffset& o : around) {
      const int x = cx + o.dx, y = cy + o.dy;
      if (!frame.size.contains(x, y) || frame.surfaces.map(x, y) == 0) continue;
      const int surface = frame.surfaces.map(x, y) - 1;
      const bool own = frame.scored_surfaces[static_cast<std::size_t>(surface)].object == edge.object;
      if (own && std::hypot(x - s.x, y - s.y) <= neighbourhood_px + distance_slack_px) near.insert(surface);
    }
    for (const int surface : near) ++samples_near[surface];
  }
  for (const auto& [surface, count] : samples_near)
    if (2 * count >= static_cast<int>(edge.samples.size())) edge.surfaces.push_back(surface);
}

void add_edges(const Truth& truth, FrameTruth& out) {
  const double reach_px = std::max<double>(edge_curve_px, out.tolerance_px()) + 1;
  for (auto& distance : out.edge_distance_px)
    distance = Image<float>(out.size, std::numeric_limits<float>::infinity());
  for (const TruthEdge& edge : truth.edges) {
    const bool counts = length_px(edge.line) >= counted_edge_length_px;
    if (edge.kind == EdgeKind::none) throw Error(ErrorKind::data, "a truth edge has no kind");
    out.edges.push_back(
        {edge.number, edge.object, edge.kind, edge.graspable, counts, edge.line, sample_line(edge.line)});
    add_bounded_surfaces(out, out.edges.back());
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

FrameTruth frame_truth(const Truth& truth, const Image<std::uint16_t>& object_masks,
                       const Image<float>& depth_m, std::vector<TruePose> poses) {
  TruthMap map = rasterise(truth, object_masks, depth_m);
  FrameTruth out{.size = truth.size, .has_surfaces = true};
  add_surfaces(truth, map, out);
  out.surfaces.regions = std::move(map.regions);
  out.surfaces.outlines = region_outlines(out.surfaces.map, out.surfaces.size(), out.surfaces.regions);
  out.poses = std::move(poses);
  add_support_parts(depth_m, out);
  add_edges(truth, out);
  if (!object_masks.empty()) {
    out.has_masks = true;
    out.mask_object = object_masks;
    out.objects.regions = out.surfaces.regions;
    add_objects(objects_of_surfaces(out), out);
  }
  add_near_object(out);
  return out;
}

FrameTruth frame_truth(const Image<std::uint16_t>& object_masks, const Image<float>& depth_m) {
  if (!depth_m.empty() && depth_m.size() != object_masks.size())
    throw Error(ErrorKind::data, "depth: size differs from the object masks");
  FrameTruth out{.size = object_masks.size(), .has_masks = true};
  out.mask_object = object_masks;
  out.objects.regions = Image<TruthRegion>(out.size, TruthRegion::background);
  for (int y = 0; y < out.size.height; ++y)
    for (int x = 0; x < out.size.width; ++x)
      if (object_masks(x, y) == 0 && !depth_m.empty() && depth_m(x, y) == 0)
        out.objects.regions(x, y) = TruthRegion::ignored;
  add_objects(object_masks, out);
  add_near_object(out);
  return out;
}

}  // namespace facet
