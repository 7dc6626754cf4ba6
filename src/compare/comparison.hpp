#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compare/policy.hpp"
#include "record/run_record.hpp"

namespace facet {

/// One measured value of two builds, or of two runs, and what follows.
struct ComparedValue {
  MeasuredKind kind = MeasuredKind::accuracy;
  std::string method{}, dataset{};
  std::string name{};                       ///< a metric, a stage or "total"
  std::optional<double> before{}, after{};  ///< latency: ms on the machine of the run before
  std::optional<double> change{};           ///< after - before
  std::optional<Interval> interval{};       ///< 95 %, of the change
  std::optional<double> p{};                ///< of no change
  int n = 0;                                ///< frames, over all rounds
  bool vanished = false;                    ///< measured before, and no more
  Verdict verdict = Verdict::not_measured;
  std::string reason{};
  Rule rule{};
};

struct Comparison {
  std::vector<ComparedValue> values;
  std::vector<std::string> vanished;  ///< methods on data sets, frames, and required values that are gone
  std::vector<std::string> notes;
};

/// Rounds of one build in the order they ran; one for a stored run.
using Rounds = std::span<const RunRecord>;

/// Compares build by build, paired per frame: scores of the first rounds, times of all of them. Times are the
/// lower quartile of a frame's repeats, in relation to the calibration block that was timed beside them.
Comparison compare_rounds(Rounds before, Rounds after, const Policy& policy,
                          const BootstrapOptions& options = {});

/// A latency regression stays one only where `second`, measured anew, shows it again.
void confirm(Comparison& first, const Comparison& second);

// Its parts, one file each.
using MethodOnDataset = std::pair<std::string, std::string>;
/// What both sides have; what only the side before has goes to `vanished`.
std::vector<MethodOnDataset> common_results(const RunRecord& before, const RunRecord& after, Comparison& out);
void compare_accuracy(const MethodOnDataset& what, const RunRecord& before, const RunRecord& after,
                      const Policy& policy, const BootstrapOptions& options, Comparison& out);
void compare_latency(const MethodOnDataset& what, Rounds before, Rounds after, const Policy& policy,
                     const BootstrapOptions& options, Comparison& out);

}  // namespace facet
