#pragma once

#include "score/intervals.hpp"
#include "score/metrics.hpp"

namespace facet {

/// Every frame of a data set that a method was scored on. What is kept of a frame does not grow with its
/// pixels.
struct ScoreCollection {
  struct Frame {
    FrameScore score;
    std::string sequence;  ///< "" = a frame by itself
  };
  std::vector<Frame> frames;  ///< scored, or failed (score_missing_prediction())
  int harness_errors = 0;     ///< frames that could not be scored through no fault of the method
};

/// What every table shows.
struct FrameCounts {
  int n_total = 0, n_scored = 0, n_method_failed = 0, n_harness_error = 0;
};

/// A metric over frames.
struct MetricSummary {
  std::string name;
  std::string not_provided;  ///< why there is no value; empty where there is one
  bool is_proportion = false;
  double hit = 0, n = 0;                   ///< pooled numerator and denominator, proportions only
  std::optional<double> micro;             ///< of the pooled counts; nothing for a denominator of 0
  std::optional<Interval> micro_interval;  ///< Wilson for proportions, bootstrap otherwise
  std::optional<double> macro;             ///< mean over frames
  std::optional<Interval> macro_interval;  ///< bootstrap
  int macro_frames = 0;                    ///< frames in that mean
  int frames_without = 0;                  ///< annotated frames left out of it, their denominator being 0
  int frames_not_annotated = 0;            ///< whose truth lacks what the metric needs
};

/// Errors over all surfaces of all frames.
struct ErrorSummary {
  std::string name;
  std::string not_provided;
  double p50 = 0, p95 = 0;
  int n = 0;
};

/// A pooled proportion at several thresholds.
struct CurveSummary {
  std::string name;
  std::string not_provided;
  std::vector<double> thresholds;
  std::vector<Tally> tallies;
};

struct ScoreSummary {
  FrameCounts counts;
  std::vector<MetricSummary> metrics;  ///< in the order of score_metrics()
  std::vector<ErrorSummary> errors;    ///< normal_error_deg, offset_error_m, lateral_error_m, ...
  std::vector<CurveSummary> curves;

  /// Throws Error{internal} for an unknown name.
  const MetricSummary& metric(const std::string& name) const;
};

/// Summary over all frames. A metric is not provided where no frame's truth, or no frame's prediction, has
/// what it needs; where some predictions have it, the frames of the others count without any hit, as failed
/// frames do. There are no bootstrap intervals for fewer than two frames.
ScoreSummary summarise_scores(const ScoreCollection& collection, const BootstrapOptions& options = {});

/// Summary of the frames of similar clutter.
struct Stratum {
  std::string axis;   ///< "objects", "surfaces", "occluded_share", "contacts"
  std::string label;  ///< "1-3"
  ScoreSummary summary;
};

/// Every stratum that has frames. Frames with a harness error are in none, and frames without annotated
/// surfaces or edges only where their clutter is known.
std::vector<Stratum> stratify_scores(const ScoreCollection& collection, const BootstrapOptions& options = {});

}  // namespace facet
