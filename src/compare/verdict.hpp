#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "score/intervals.hpp"

namespace facet {

enum class Verdict {
  regressed,
  improved,
  ok,              ///< a worsening beyond the tolerance is ruled out
  inconclusive,    ///< it is not
  not_measured,    ///< no value on one side, or too few samples
  not_comparable,  ///< other frames, another machine
};
std::string_view verdict_name(Verdict verdict);

/// Which change is for the worse: of a value that should be high, of one that should be low, any.
enum class Better { higher, lower, same };

/// What is asked of one measured value.
struct Rule {
  std::optional<Better> better{};  ///< empty: as the metric's definition says
  double abs_tolerance = 0;        ///< in the unit of the value
  double rel_tolerance = 0;        ///< share of the value before; the larger of the two tolerances holds
  int least_n = 2;                 ///< frames, or rounds times frames
  /// The value is deterministic: on the same frames a change is a fact, not a sample.
  bool exact = false;
  bool hard = true;       ///< a regression fails the gate; otherwise it is a warning
  bool required = false;  ///< its absence fails the gate
};

/// A change as it was estimated.
struct Change {
  double before = 0, after = 0;
  std::optional<Interval> interval{};  ///< 95 %, of after - before
  std::optional<double> p{};           ///< of no change
  int n = 0;
};

struct Judgement {
  Verdict verdict = Verdict::not_measured;
  std::string reason;  ///< empty for regressed, improved and ok
};

/// Regressed: worse by more than the tolerance, p below alpha, and the interval excludes the tolerance.
/// Improved: the same for the better. Ok: the interval excludes a worsening beyond the tolerance. `better`
/// wins over the rule's absent one.
Judgement judge(const Change& change, const Rule& rule, Better better, double alpha);

}  // namespace facet
