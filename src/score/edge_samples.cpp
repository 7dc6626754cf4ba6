#include "score/edge_samples.hpp"

#include <cmath>

namespace facet {
namespace {

constexpr double rounding_px = 0.7072;  // the largest distance of a sample to the nearest pixel centre

}  // namespace

SampleSearch::SampleSearch(const Image<std::uint8_t>& codes, double reach_px)
    : codes_(codes), offsets_(offsets_within(reach_px + rounding_px)) {}

std::vector<SampleHit> SampleSearch::search(const ScoredEdge& edge) const {
  std::vector<SampleHit> hits;
  hits.reserve(edge.samples.size());
  for (const ImagePoint sample : edge.samples) hits.push_back(search(sample, edge));
  return hits;
}

SampleHit SampleSearch::search(ImagePoint sample, const ScoredEdge& edge) const {
  SampleHit hit;
  const int cx = static_cast<int>(std::lround(sample.x)), cy = static_cast<int>(std::lround(sample.y));
  for (const GridOffset& o : offsets_) {
    if (o.length_px - rounding_px > hit.same_kind_px + distance_slack_px) break;
    const int x = cx + o.dx, y = cy + o.dy;
    if (!codes_.size().contains(x, y) || codes_(x, y) == 0) continue;
    const double distance = std::hypot(x - sample.x, y - sample.y);
    hit.any_kind_px = std::min(hit.any_kind_px, distance);
    if (edge_kind_of(codes_(x, y)) != edge.kind) continue;
    if (distance > hit.same_kind_px + distance_slack_px) continue;
    const bool right = ((codes_(x, y) & graspable_edge_bit) != 0) == edge.graspable;
    const bool as_near = distance >= hit.same_kind_px - distance_slack_px;
    hit.label_right = right || (as_near && hit.label_right);
    hit.same_kind_px = std::min(hit.same_kind_px, distance);
  }
  return hit;
}

}  // namespace facet
