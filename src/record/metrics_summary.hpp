#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "record/frame_row.hpp"
#include "record/manifest.hpp"

namespace facet {

/// Which groups of scores are wanted.
struct ScoreGroups {
  bool surfaces = true, edges = true, objects = true, poses = true;
  bool contains(std::string_view metric) const;
};

/// metrics/summary.json: one result per method and data set, with the counts of its frames, the pooled
/// (micro) and the mean (macro) value of every metric and its interval, and the same pooled values for frames
/// of similar clutter. What has no value is null, with the reason. datasets/README.md lists the keys.
std::string metrics_summary_json(const Manifest& manifest, const std::vector<FrameRow>& rows,
                                 const ScoreGroups& groups = {});

/// A value of the summary.
struct ScoreCell {
  std::optional<double> value, lo, hi, hit, n;
  std::string reason;  ///< why there is no value
};
/// Quantiles of an error over surfaces.
struct ErrorCell {
  std::optional<double> p50, p95;
  int n = 0;
};
struct ScoreStratum {
  std::string axis, label;
  int frames = 0;
  std::map<std::string, ScoreCell> micro;
};
/// What the summary says of one method on one data set.
struct ScoreResult {
  std::string method, dataset;
  std::map<std::string, int> counts;         ///< n_total, n_scored, ...
  std::map<std::string, int> truth_sources;  ///< frames by where their truth is from
  std::map<std::string, ScoreCell> micro, macro;
  std::map<std::string, ErrorCell> errors;
  std::vector<ScoreStratum> strata;

  /// The pooled value of a metric; one without a value, with the reason, where there is none of that name.
  const ScoreCell& cell(const std::string& metric) const;
};

/// Reads what metrics_summary_json() wrote. Throws Error{data} for anything else.
std::vector<ScoreResult> score_results_from_json(std::string_view text);

}  // namespace facet
