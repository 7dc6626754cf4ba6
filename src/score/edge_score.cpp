#include "score/edge_score.hpp"

#include <algorithm>
#include <fmt/core.h>

#include "core/error.hpp"
#include "score/edge_samples.hpp"
#include "score/offsets.hpp"

namespace facet {
namespace {

constexpr double strict_px = 3;

bool most_of(std::ptrdiff_t part, std::ptrdiff_t whole) {
  return 10 * part >= 7 * whole;  // at least 70 %, without rounding
}

/// Samples with a pixel of the kind within the tolerance, and those of them with the right label.
struct HitCounts {
  std::ptrdiff_t hit = 0, right = 0;
};
HitCounts count_hits(const std::vector<SampleHit>& hits, double tolerance_px) {
  HitCounts counts;
  for (const SampleHit& h : hits) {
    if (h.same_kind_px > tolerance_px + distance_slack_px) continue;
    ++counts.hit;
    if (h.label_right) ++counts.right;
  }
  return counts;
}

bool is_detected(const std::vector<SampleHit>& hits, double tolerance_px) {
  const auto [hit, right] = count_hits(hits, tolerance_px);
  return hit > 0 && most_of(hit, std::ssize(hits)) && most_of(right, hit);
}

EdgeOutcome outcome_of(const ScoredEdge& edge, const std::vector<SampleHit>& hits, double tolerance_px) {
  const auto [hit, right] = count_hits(hits, tolerance_px);
  return {edge.number,
          edge.object,
          edge.kind,
          edge.graspable,
          static_cast<int>(hits.size()),
          static_cast<int>(hit),
          static_cast<int>(right),
          is_detected(hits, tolerance_px)};
}

bool is_located(const std::vector<SampleHit>& hits, double tolerance_px) {
  const auto hit = std::count_if(hits.begin(), hits.end(), [&](const SampleHit& h) {
    return h.any_kind_px <= tolerance_px + distance_slack_px;
  });
  return hit > 0 && most_of(hit, std::ssize(hits));
}

void add(const ScoredEdge& edge, bool detected, EdgeRecall& recall) {
  recall.all.add(detected);
  if (edge.graspable) recall.graspable.add(detected);
  (edge.kind == EdgeKind::depth    ? recall.depth
   : edge.kind == EdgeKind::convex ? recall.convex
                                   : recall.concave)
      .add(detected);
}

void add_recall(const FrameTruth& frame, const ScoredEdge& edge, const std::vector<SampleHit>& hits,
                EdgeScore& score) {
  const double tolerance_px = frame.tolerance_px();
  add(edge, is_detected(hits, tolerance_px), score.recall_6px);
  add(edge, is_detected(hits, strict_px), score.recall_3px);
  add(edge, is_located(hits, tolerance_px), score.recall_kind_ignored_6px);
  add(edge, is_located(hits, strict_px), score.recall_kind_ignored_3px);
  for (std::size_t i = 0; i < edge_curve_px; ++i)
    add(edge, is_detected(hits, static_cast<double>(i) + 1), score.recall_curve[i]);
  score.outcomes.push_back(outcome_of(edge, hits, tolerance_px));
}

/// Distance of a pixel to the truth line of its kind, and of any kind.
struct LineDistance {
  double same_kind_px, any_kind_px;
};
LineDistance line_distance(const FrameTruth& frame, int x, int y, EdgeKind kind) {
  const auto& d = frame.edge_distance_px;
  return {d[static_cast<std::size_t>(kind) - 1](x, y), std::min({d[0](x, y), d[1](x, y), d[2](x, y)})};
}

bool is_of_interest(const FrameTruth& frame, int x, int y, double any_kind_px, double tolerance_px) {
  return frame.near_object(x, y) != 0 && (frame.surfaces.regions(x, y) != TruthRegion::ignored ||
                                          any_kind_px <= tolerance_px + distance_slack_px);
}

void add_precision(EdgeKind kind, bool hit, EdgePrecision& precision) {
  precision.all.add(hit);
  (kind == EdgeKind::depth    ? precision.depth
   : kind == EdgeKind::convex ? precision.convex
                              : precision.concave)
      .add(hit);
}

void add_pixel(const FrameTruth& frame, int x, int y, EdgeKind kind, EdgeScore& score) {
  if (frame.near_object(x, y) == 0) return;
  const LineDistance d = line_distance(frame, x, y, kind);
  const auto at = [&](double tolerance_px, EdgePrecision& precision, Tally& kind_ignored) {
    if (!is_of_interest(frame, x, y, d.any_kind_px, tolerance_px)) return;
    add_precision(kind, d.same_kind_px <= tolerance_px + distance_slack_px, precision);
    kind_ignored.add(d.any_kind_px <= tolerance_px + distance_slack_px);
  };
  at(frame.tolerance_px(), score.precision_6px, score.precision_kind_ignored_6px);
  at(strict_px, score.precision_3px, score.precision_kind_ignored_3px);
  for (int i = 0; i < edge_curve_px; ++i) {
    const double tolerance_px = i + 1;
    if (is_of_interest(frame, x, y, d.any_kind_px, tolerance_px))
      score.precision_curve[static_cast<std::size_t>(i)].add(d.same_kind_px <=
                                                             tolerance_px + distance_slack_px);
  }
}

EdgeKind kind_of(std::uint8_t code) {
  const int kind = code & ~graspable_edge_bit;
  if (kind < 1 || kind > 3)
    throw Error(ErrorKind::data, fmt::format("unknown code {} in the predicted edges", code));
  return static_cast<EdgeKind>(kind);
}

}  // namespace

bool is_of_interest(const FrameTruth& frame, int x, int y, double tolerance_px) {
  return is_of_interest(frame, x, y, line_distance(frame, x, y, EdgeKind::depth).any_kind_px, tolerance_px);
}

EdgeScore score_edges(const FrameTruth& frame, const Image<std::uint8_t>& codes) {
  EdgeScore score;
  const SampleSearch search(codes, std::max<double>(edge_curve_px, frame.tolerance_px()));
  for (const ScoredEdge& edge : frame.edges)
    if (edge.counts) add_recall(frame, edge, search.search(edge), score);
  for (int y = 0; y < codes.height(); ++y)
    for (int x = 0; x < codes.width(); ++x)
      if (codes(x, y) != 0) add_pixel(frame, x, y, kind_of(codes(x, y)), score);
  return score;
}

}  // namespace facet
