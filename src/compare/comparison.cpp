#include "compare/comparison.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace facet {
namespace {

std::set<MethodOnDataset> results_of(const RunRecord& run) {
  std::set<MethodOnDataset> results;
  for (const FrameRow& row : run.frames) results.insert({row.method, row.dataset});
  return results;
}

/// Values that a rule by name requires, and nobody measured.
void add_unmeasured(const Policy& policy, Comparison& out) {
  const auto add = [&](MeasuredKind kind, const std::map<std::string, Rule>& rules) {
    for (const auto& [name, rule] : rules) {
      const bool measured =
          std::any_of(out.values.begin(), out.values.end(),
                      [&](const ComparedValue& value) { return value.kind == kind && value.name == name; });
      if (rule.required && name != "*" && !measured)
        out.vanished.push_back(fmt::format("{}, which the policy requires", name));
    }
  };
  add(MeasuredKind::accuracy, policy.accuracy);
  add(MeasuredKind::latency, policy.latency);
}

}  // namespace

std::vector<MethodOnDataset> common_results(const RunRecord& before, const RunRecord& after,
                                            Comparison& out) {
  const std::set<MethodOnDataset> there = results_of(after);
  std::vector<MethodOnDataset> common;
  for (const MethodOnDataset& what : results_of(before))
    if (there.contains(what))
      common.push_back(what);
    else
      out.vanished.push_back(fmt::format("method {} on data set {}", what.first, what.second));
  return common;
}

Comparison compare_rounds(Rounds before, Rounds after, const Policy& policy,
                          const BootstrapOptions& options) {
  Comparison out;
  for (const MethodOnDataset& what : common_results(before.front(), after.front(), out)) {
    compare_accuracy(what, before.front(), after.front(), policy, options, out);
    compare_latency(what, before, after, policy, options, out);
  }
  for (const ComparedValue& value : out.values)
    if (value.vanished && value.rule.required)
      out.vanished.push_back(fmt::format("{} of {} on {}", value.name, value.method, value.dataset));
  add_unmeasured(policy, out);
  return out;
}

void confirm(Comparison& first, const Comparison& second) {
  for (ComparedValue& value : first.values) {
    if (value.kind != MeasuredKind::latency || value.verdict != Verdict::regressed) continue;
    const auto again =
        std::find_if(second.values.begin(), second.values.end(), [&](const ComparedValue& other) {
          return other.kind == value.kind && other.method == value.method && other.dataset == value.dataset &&
                 other.name == value.name;
        });
    if (again != second.values.end() && again->verdict == Verdict::regressed) continue;
    value.verdict = Verdict::inconclusive;
    value.reason = "slower, and not so when measured again";
  }
}

}  // namespace facet
