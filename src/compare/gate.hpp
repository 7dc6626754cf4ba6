#pragma once

#include <string>
#include <vector>

#include "compare/comparison.hpp"

namespace facet {

enum class GateResult {
  passed,
  failed,        ///< something regressed or vanished
  not_measured,  ///< too few samples, another machine, nothing in common, or inconclusive where that fails
};

struct GateDecision {
  GateResult result = GateResult::passed;
  std::vector<std::string> failures;  ///< why it is not passed
  std::vector<std::string> warnings;
};

/// What a policy makes of a comparison. Soft rules warn. Failed wins over not measured.
GateDecision decide(const Comparison& comparison, const Policy& policy);

/// Nothing has to be better or worse, only to be there: failed where something vanished, not measured where
/// nothing is in common.
GateDecision decide_comparison(const Comparison& comparison);

/// "surface_recall_0.5 of default on mixed: 0.9100 -> 0.8950, change -0.0150 [-0.0201, -0.0080]".
std::string describe(const ComparedValue& value);

}  // namespace facet
