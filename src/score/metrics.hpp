#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "score/frame_score.hpp"

namespace facet {

/// What a metric is computed from. The sums of the frames give the pooled value.
using MetricSums = std::array<double, 4>;

/// How the value follows from the sums.
enum class MetricRule {
  proportion,  ///< sums[0] of sums[1], counted things: Wilson interval
  ratio,       ///< sums[0] / sums[1]
  precision,   ///< of precision_recall(sums), with its edge cases
  recall,
  f_score,
};

/// A number that every table of scores may show.
struct Metric {
  std::string name;
  AnnotatedParts needs_truth;
  PredictedParts needs_prediction;
  MetricRule rule = MetricRule::proportion;
  std::function<MetricSums(const FrameScore&)> sums;
  bool less_is_better = false;  ///< a perfect prediction has 0, otherwise 1

  /// Nothing where the denominator is 0.
  std::optional<double> value(const MetricSums& sums_of_frames) const;
  /// Whether the truth of the frame has what the metric needs.
  bool is_annotated(const FrameScore& frame) const;
  /// Whether its prediction has.
  bool is_predicted(const FrameScore& frame) const;
};

/// All metrics, in the order of tables. Names end in a threshold where they have one: "surface_recall_0.5",
/// "edge_recall_graspable_6px".
const std::vector<Metric>& score_metrics();
/// Throws Error{internal} for an unknown name.
const Metric& score_metric(const std::string& name);

/// A proportion at several thresholds.
struct MetricCurve {
  std::string name;
  AnnotatedParts needs_truth;
  PredictedParts needs_prediction;
  std::vector<double> thresholds;
  std::function<std::vector<Tally>(const FrameScore&)> tallies;  ///< one per threshold
};
const std::vector<MetricCurve>& score_curves();

}  // namespace facet
