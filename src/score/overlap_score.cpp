#include "score/overlap_score.hpp"

#include <cmath>

#include "score/assignment.hpp"

namespace facet {

OverlapScore score_overlap(const RegionComparison& comparison) {
  const TruthLabels& truth = comparison.truth;
  const PredictedRegions& predicted = comparison.predicted;
  const std::vector<Outline>& outlines = comparison.outlines;
  OverlapScore score{.truth = static_cast<int>(truth.size())};
  for (std::size_t t = 0; t < truth.size(); ++t) {
    score.truth_px += truth.area_px[t];
    score.boundary_truth += static_cast<int>(truth.outlines[t].size());
  }
  for (std::size_t r = 0; r < outlines.size(); ++r) {
    if (!is_compared(comparison.classes[r])) continue;
    ++score.predicted;
    score.predicted_px += predicted.regions[r].area_px;
    score.boundary_predicted += static_cast<int>(outlines[r].size());
  }
  std::vector<WeightedPair> pairs;
  for (const Overlap& o : comparison.overlaps) {
    const auto t = static_cast<std::size_t>(o.a), r = static_cast<std::size_t>(o.b);
    if (is_compared(comparison.classes[r]))
      pairs.push_back({o.a, o.b, 2.0 * o.px / (truth.area_px[t] + predicted.regions[r].area_px)});
  }
  NearbyCounter nearby(truth.map.size(), boundary_radius_px(truth.map.size()));
  for (const WeightedPair& pair : best_assignment(pairs)) {
    const auto t = static_cast<std::size_t>(pair.row), r = static_cast<std::size_t>(pair.column);
    score.common_px +=
        static_cast<int>(std::lround(pair.weight * (truth.area_px[t] + predicted.regions[r].area_px) / 2));
    score.boundary_predicted_hit += nearby.count(outlines[r], truth.outlines[t]);
    score.boundary_truth_hit += nearby.count(truth.outlines[t], outlines[r]);
    if (pair.weight > 0.75) ++score.found_75;
  }
  return score;
}

PrecisionRecall precision_recall(double predicted_hit, double predicted, double truth_hit, double truth) {
  const double p = predicted > 0 ? predicted_hit / predicted : 1;
  const double r = truth > 0 ? truth_hit / truth : 1;
  if ((predicted > 0) != (truth > 0)) return {predicted > 0 ? 0 : p, truth > 0 ? 0 : r, 0};
  return {p, r, p + r > 0 ? 2 * p * r / (p + r) : 0};
}

}  // namespace facet
