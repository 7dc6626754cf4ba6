#pragma once

#include "score/summary.hpp"

namespace facet {

using ScoredFrames = std::vector<ScoreCollection::Frame>;

/// What either has.
PredictedParts united(const PredictedParts& a, const PredictedParts& b);

/// Why there is no value for what needs these parts, empty where there is one.
std::string reason_not_provided(const ScoredFrames& frames, const AnnotatedParts& needs_truth,
                                const PredictedParts& needs_prediction);

/// A metric's sums and value per frame; frames without annotation have neither.
struct MetricColumn {
  std::vector<std::optional<MetricSums>> sums;
  std::vector<std::optional<double>> values;

  MetricColumn(const ScoredFrames& frames, const Metric& metric);
  /// Value of the pooled sums of the frames with these indices.
  std::optional<double> micro(const std::vector<int>& frames, const Metric& metric) const;
  /// Mean of their values.
  std::optional<double> macro(const std::vector<int>& frames) const;
};

std::vector<int> all_indices(const ScoredFrames& frames);
std::vector<std::string> sequences_of(const ScoredFrames& frames);

}  // namespace facet
