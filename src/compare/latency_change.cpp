#include <algorithm>
#include <fmt/format.h>

#include "compare/comparison.hpp"
#include "compare/quiet_times.hpp"
#include "score/paired_scores.hpp"

namespace facet {
namespace {

/// A frame's time on both sides in one round, each over its own calibration.
struct TimePair {
  double before = 0, after = 0;
};

/// The pairs of one stage, with the round of each as its group.
struct StagePairs {
  std::vector<TimePair> pairs;
  std::vector<std::string> rounds;
};

std::string environment_of(const RunRecord& run, const std::string& key) {
  for (const auto& [name, value] : run.environment)
    if (name == key) return value;
  return {};
}

/// Why times of the two cannot be set in relation; empty where they can.
std::string obstacle(const RunRecord& before, const RunRecord& after, bool calibrated) {
  if (before.manifest.backend != after.manifest.backend)
    return fmt::format("back ends {} and {}", before.manifest.backend, after.manifest.backend);
  if (before.manifest.timing_threads != after.manifest.timing_threads)
    return fmt::format("{} and {} threads inside a frame", before.manifest.timing_threads,
                       after.manifest.timing_threads);
  for (const char* key : {"build.build_type", "build.compiler"})
    if (environment_of(before, key) != environment_of(after, key))
      return fmt::format("{}: {} and {}", key, environment_of(before, key), environment_of(after, key));
  // The calibration block runs on the CPU.
  const std::string device = environment_of(before, "gpu.device");
  if (before.manifest.backend != "cpu" && device != environment_of(after, "gpu.device"))
    return fmt::format("gpu.device: {} and {}", device, environment_of(after, "gpu.device"));
  if (calibrated) return {};
  const std::string cpu = environment_of(before, "cpu.model");
  return cpu == environment_of(after, "cpu.model") ? "" : "another CPU model and no calibration block";
}

/// Index of a stage; npos where the run has no such stage.
std::size_t index_of_stage(const QuietTimes& times, const std::string& stage) {
  return static_cast<std::size_t>(std::find(times.stages.begin(), times.stages.end(), stage) -
                                  times.stages.begin());
}

struct RoundTimes {
  QuietTimes before, after;
  bool calibrated = false;
};

std::vector<RoundTimes> times_of(const MethodOnDataset& what, Rounds before, Rounds after) {
  std::vector<RoundTimes> rounds;
  for (std::size_t r = 0; r < std::min(before.size(), after.size()); ++r) {
    RoundTimes round{quiet_times(before[r], what), quiet_times(after[r], what)};
    round.calibrated = !round.before.calibration_ms.empty() && !round.after.calibration_ms.empty();
    rounds.push_back(std::move(round));
  }
  return rounds;
}

StagePairs pairs_of(const std::vector<RoundTimes>& rounds, const std::string& stage) {
  StagePairs out;
  for (std::size_t r = 0; r < rounds.size(); ++r) {
    const auto& [before, after, calibrated] = rounds[r];
    const std::size_t i = index_of_stage(before, stage), k = index_of_stage(after, stage);
    if (i == before.stages.size() || k == after.stages.size()) continue;
    for (const auto& [frame, ms] : before.frames_ms) {
      const auto found = after.frames_ms.find(frame);
      if (found == after.frames_ms.end()) continue;
      // In ms on the machine of the run before.
      const double scale = calibrated ? before.calibration_ms.at(frame) / after.calibration_ms.at(frame) : 1;
      out.pairs.push_back({ms[i], found->second[k] * scale});
      out.rounds.push_back(rounds.size() > 1 ? std::to_string(r) : "");
    }
  }
  return out;
}

TimePair means_of(const std::vector<TimePair>& pairs, const auto& indices) {
  TimePair sum;
  for (const auto i : indices) {
    sum.before += pairs[static_cast<std::size_t>(i)].before;
    sum.after += pairs[static_cast<std::size_t>(i)].after;
  }
  const auto n = static_cast<double>(std::size(indices));
  return {sum.before / n, sum.after / n};
}

void estimate(const StagePairs& stage, const BootstrapOptions& options, ComparedValue& value) {
  std::vector<int> all(stage.pairs.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  const TimePair mean = means_of(stage.pairs, all);
  value.before = mean.before;
  value.after = mean.after;
  value.change = mean.after - mean.before;
  value.n = static_cast<int>(all.size());
  if (all.size() < 2) return;
  std::vector<double> replicates;
  for_each_resample(stage.rounds, options, [&](const std::vector<int>& drawn) {
    const TimePair m = means_of(stage.pairs, drawn);
    replicates.push_back(m.after - m.before);
  });
  value.p = two_sided_p(replicates);
  value.interval = percentile_interval(std::move(replicates));
}

/// One run each holds no scatter between runs. Where repeats of a frame already differ by more than the
/// tolerance, a change that exceeds it proves a busy machine as much as a slow build.
void doubt(const std::vector<RoundTimes>& rounds, const std::string& stage, ComparedValue& value) {
  if (rounds.size() > 1 || (value.verdict != Verdict::regressed && value.verdict != Verdict::improved))
    return;
  const auto scatter_in = [&](const QuietTimes& times) {
    return times.scatter[index_of_stage(times, stage)];
  };
  const double scatter = std::max(scatter_in(rounds.front().before), scatter_in(rounds.front().after));
  const double tolerance = std::max(value.rule.rel_tolerance, value.rule.abs_tolerance / *value.before);
  if (scatter <= tolerance) return;
  value.verdict = Verdict::inconclusive;
  value.reason =
      fmt::format("the machine was busy: repeats of a frame scatter by {:.0f} %, tolerance {:.0f} %",
                  100 * scatter, 100 * tolerance);
}

}  // namespace

void compare_latency(const MethodOnDataset& what, Rounds before, Rounds after, const Policy& policy,
                     const BootstrapOptions& options, Comparison& out) {
  const std::vector<RoundTimes> rounds = times_of(what, before, after);
  const auto& first = rounds.front();
  if (first.before.frames_ms.empty() && first.after.frames_ms.empty()) return;
  const bool calibrated =
      std::all_of(rounds.begin(), rounds.end(), [](const auto& r) { return r.calibrated; });
  const std::string reason = obstacle(before.front(), after.front(), calibrated);
  for (const std::string& stage : first.before.stages) {
    const Rule* rule = policy.find(MeasuredKind::latency, stage);
    if (rule == nullptr) continue;
    ComparedValue value{
        .kind = MeasuredKind::latency, .method = what.first, .dataset = what.second, .name = stage};
    value.rule = *rule;
    const StagePairs pairs = pairs_of(rounds, stage);
    if (pairs.pairs.empty()) {
      value.vanished = !first.before.frames_ms.empty();
      value.reason = value.vanished ? "no time any more" : "no time before";
    } else {
      estimate(pairs, options, value);
      const Judgement judgement = judge({*value.before, *value.after, value.interval, value.p, value.n},
                                        value.rule, Better::lower, policy.alpha);
      value.verdict = reason.empty() ? judgement.verdict : Verdict::not_comparable;
      value.reason = reason.empty() ? judgement.reason : reason;
      doubt(rounds, stage, value);
    }
    out.values.push_back(std::move(value));
  }
}

}  // namespace facet
