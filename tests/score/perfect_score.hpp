#pragma once

#include <gtest/gtest.h>

#include "score/metrics.hpp"

namespace facet {

/// Expects the best value of every metric that the frame provides, and of every point of every curve from
/// the given tolerance of edges on (two edges that share pixels cannot both be drawn where they are).
inline void expect_perfect(const FrameScore& score, double least_edge_px = 2) {
  for (const Metric& metric : score_metrics()) {
    if (!metric.is_annotated(score)) continue;
    ASSERT_TRUE(metric.is_predicted(score)) << metric.name;
    const bool less_is_better = metric.name == "object_leakage" || metric.name == "hoover_over_0.8" ||
                                metric.name == "hoover_under_0.8" || metric.name == "hoover_missed_0.8" ||
                                metric.name == "hoover_noise_0.8";
    const auto value = metric.value(metric.sums(score));
    if (value) {
      EXPECT_NEAR(*value, less_is_better ? 0 : 1, metric.name == "pose_auc" ? 1e-3 : 1e-12) << metric.name;
    }
  }
  for (const MetricCurve& curve : score_curves()) {
    const std::vector<Tally> tallies = curve.tallies(score);
    for (std::size_t i = 0; i < tallies.size(); ++i) {
      if (curve.name.starts_with("edge") && curve.thresholds[i] < least_edge_px) continue;
      EXPECT_EQ(tallies[i].hit, tallies[i].n) << curve.name << " at " << curve.thresholds[i];
    }
  }
}

}  // namespace facet
