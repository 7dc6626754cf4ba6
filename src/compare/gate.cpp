#include "compare/gate.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace facet {
namespace {

/// What a value that did not pass means under its rule.
void weigh(const ComparedValue& value, const Policy& policy, GateDecision& decision, bool& unmeasured) {
  const std::string text = fmt::format("{}: {}", verdict_name(value.verdict), describe(value));
  const bool has_both = value.before && value.after;
  const bool is_unmeasured = (value.verdict == Verdict::not_measured && has_both) ||
                             value.verdict == Verdict::not_comparable ||
                             (value.verdict == Verdict::inconclusive && policy.inconclusive_fails);
  if (value.verdict == Verdict::ok || value.verdict == Verdict::improved) return;
  if (value.rule.hard && value.verdict == Verdict::regressed) {
    decision.result = GateResult::failed;
    decision.failures.push_back(text);
  } else if (value.rule.hard && is_unmeasured) {
    unmeasured = true;
    decision.failures.push_back(text);
  } else {
    decision.warnings.push_back(text);
  }
}

void add_vanished(const Comparison& comparison, GateDecision& decision) {
  for (const std::string& what : comparison.vanished) decision.failures.push_back("vanished: " + what);
  if (!comparison.vanished.empty()) decision.result = GateResult::failed;
}

}  // namespace

GateDecision decide(const Comparison& comparison, const Policy& policy) {
  GateDecision decision;
  bool unmeasured = false;
  add_vanished(comparison, decision);
  for (const ComparedValue& value : comparison.values) weigh(value, policy, decision, unmeasured);
  if (comparison.values.empty()) {
    unmeasured = true;
    decision.failures.push_back("nothing that the policy names was measured in both runs");
  }
  if (unmeasured && decision.result == GateResult::passed) decision.result = GateResult::not_measured;
  return decision;
}

GateDecision decide_comparison(const Comparison& comparison) {
  GateDecision decision;
  add_vanished(comparison, decision);
  const bool any =
      std::any_of(comparison.values.begin(), comparison.values.end(), [](const ComparedValue& v) {
        return v.verdict != Verdict::not_measured && v.verdict != Verdict::not_comparable;
      });
  if (any) return decision;
  decision.failures.emplace_back("nothing can be compared");
  if (decision.result == GateResult::passed) decision.result = GateResult::not_measured;
  return decision;
}

std::string describe(const ComparedValue& value) {
  std::string text = fmt::format("{} of {} on {}", value.name, value.method, value.dataset);
  const char* unit = value.kind == MeasuredKind::latency ? " ms" : "";
  if (value.before && value.after)
    text +=
        fmt::format(": {:.4f} -> {:.4f}{}, change {:+.4f}", *value.before, *value.after, unit, *value.change);
  if (value.interval) text += fmt::format(" [{:+.4f}, {:+.4f}]", value.interval->lo, value.interval->hi);
  return value.reason.empty() ? text : text + "; " + value.reason;
}

}  // namespace facet
