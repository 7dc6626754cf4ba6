#pragma once

#include "score/summary.hpp"

namespace facet {

/// One metric of two collections over the same frames.
struct PairedScore {
  std::string metric;
  std::optional<double> before, after;        ///< pooled values
  std::optional<double> change;               ///< after - before
  std::optional<Interval> interval;           ///< paired bootstrap over frames, nested in sequences
  std::optional<double> p;                    ///< of no change, two-sided, from the same replicates
  int n = 0;                                  ///< frames that are annotated for it
  int changed = 0;                            ///< of these, frames whose sums differ
  std::string missing_before, missing_after;  ///< why there is no value; empty where there is one
};

/// The named metrics, or every one of score_metrics() where none is named, from one resampling. Throws
/// Error{internal} where the collections differ in their number of frames, or for an unknown name.
std::vector<PairedScore> pair_scores(const ScoreCollection& before, const ScoreCollection& after,
                                     const BootstrapOptions& options = {},
                                     const std::vector<std::string>& metrics = {});

/// Two-sided p of "the quantity is 0" from its bootstrap replicates: twice the smaller share beyond 0, each
/// share with one added to count and total (Davison and Hinkley 1997, 4.2), at most 1. Needs no replicates: 1
/// then.
double two_sided_p(const std::vector<double>& replicates);

}  // namespace facet
