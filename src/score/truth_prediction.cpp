#include "score/truth_prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <tuple>

#include "score/grasp_score.hpp"
#include "score/offsets.hpp"
#include "score/polyline_distance.hpp"

namespace facet {
namespace {

/// A pixel of an edge where one of another kind had been drawn already.
struct DisplacedPixel {
  ContourPoint at;
  const ScoredEdge* edge;
};

/// Draws it at the free pixel nearby that is nearest to its line.
void draw_displaced(const DisplacedPixel& pixel, const std::vector<GridOffset>& around,
                    Image<std::uint8_t>& codes) {
  ContourPoint best{};
  double best_px = std::numeric_limits<double>::infinity();
  for (const GridOffset& o : around) {
    const ContourPoint p{pixel.at.x + o.dx, pixel.at.y + o.dy};
    if (!codes.size().contains(p.x, p.y) || codes(p.x, p.y) != 0) continue;
    const double away_px =
        distance_px({static_cast<double>(p.x), static_cast<double>(p.y)}, pixel.edge->line);
    if (away_px < best_px) best = p, best_px = away_px;
  }
  if (best_px < 2) codes(best.x, best.y) = edge_code(pixel.edge->kind, pixel.edge->graspable);
}

/// Every sample at its pixel. Edges of different kinds that share pixels run beside each other, so that none
/// loses pixels to the other.
Image<std::uint8_t> draw_edges(const FrameTruth& frame) {
  Image<std::uint8_t> codes(frame.size, 0);
  std::vector<DisplacedPixel> displaced;
  std::set<std::tuple<int, int, EdgeKind>> seen;  // displaced already
  for (const ScoredEdge& edge : frame.edges) {
    const std::uint8_t code = edge_code(edge.kind, edge.graspable);
    for (const ImagePoint s : edge.samples) {
      const ContourPoint p{static_cast<int>(std::lround(s.x)), static_cast<int>(std::lround(s.y))};
      if (!codes.size().contains(p.x, p.y)) continue;
      if (codes(p.x, p.y) == 0) {
        codes(p.x, p.y) = code;
      } else if (edge_kind_of(codes(p.x, p.y)) != edge.kind && seen.insert({p.x, p.y, edge.kind}).second) {
        displaced.push_back({p, &edge});
      }
    }
  }
  const std::vector<GridOffset> around = offsets_within(2);
  for (const DisplacedPixel& pixel : displaced) draw_displaced(pixel, around, codes);
  return codes;
}

/// The two samples of one edge farthest apart between which it turns back; nothing for a straight one.
std::optional<std::array<ImagePoint, 2>> opposing_samples(const ScoredEdge& edge, double tolerance_px) {
  std::optional<std::array<ImagePoint, 2>> best;
  double best_px = 0;
  const std::size_t step = 1 + edge.samples.size() / 40;
  for (std::size_t i = 0; i < edge.samples.size(); i += step) {
    for (std::size_t j = i + step; j < edge.samples.size(); j += step) {
      const ImagePoint p = edge.samples[i], q = edge.samples[j];
      const double apart_px = std::hypot(p.x - q.x, p.y - q.y);
      if (apart_px <= best_px || !turns_back(edge, p, q, tolerance_px)) continue;
      best = {p, q};
      best_px = apart_px;
    }
  }
  return best;
}

/// Contacts in the middle of two graspable edges of the surface, or on a single one that bends round it.
void add_grasp(const FrameTruth& frame, int index, Surface& surface) {
  std::vector<const ScoredEdge*> edges;
  for (const ScoredEdge& edge : frame.edges) {
    const bool bounds = std::find(edge.surfaces.begin(), edge.surfaces.end(), index) != edge.surfaces.end();
    if (edge.graspable && bounds) edges.push_back(&edge);
  }
  Grasp grasp;
  grasp.closing_axis = {1, 0, 0};
  if (edges.size() > 1) {
    for (std::size_t k = 0; k < 2; ++k)
      grasp.contacts_px[k] = edges[k]->samples[edges[k]->samples.size() / 2];
  } else {
    const auto samples = edges.empty() ? std::nullopt : opposing_samples(*edges[0], frame.tolerance_px());
    if (!samples) return;
    grasp.contacts_px = *samples;
  }
  surface.grasps.push_back(grasp);
}

SurfacePose pose_of(const FrameTruth& frame, int number) {
  for (const TruePose& pose : frame.poses) {
    if (pose.surface != number) continue;
    if (pose.plane) return pose_of(pose);
    SurfacePose estimate;
    estimate.centre_m = pose.centroid_m;
    return estimate;
  }
  return {};
}

}  // namespace

Prediction truth_as_prediction(const FrameTruth& frame) {
  const TruthLabels& items = frame.has_surfaces ? frame.surfaces : frame.objects;
  Prediction prediction;
  prediction.labels = items.map;
  if (!frame.edges.empty()) prediction.edges = draw_edges(frame);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const int index = static_cast<int>(i);
    Surface surface;
    surface.id = index + 1;
    surface.area_px = items.area_px[i];
    if (frame.has_surfaces) {
      surface.object = frame.scored_surfaces[i].object;
      surface.curved = frame.scored_surfaces[i].curved;
      surface.graspable = frame.scored_surfaces[i].graspable;
      surface.pose = pose_of(frame, frame.scored_surfaces[i].number);
      if (surface.graspable) add_grasp(frame, index, surface);
    } else {
      surface.object = frame.object_values[i];
    }
    prediction.surfaces.push_back(std::move(surface));
  }
  return prediction;
}

}  // namespace facet
