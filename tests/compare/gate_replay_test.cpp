// How often the gate fails, replayed on timing rows that were recorded: nothing here depends on a clock.
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>

#include "compare/gate.hpp"
#include "compare/recorded_runs.hpp"
#include "compare/slowed_method.hpp"
#include "core/random.hpp"
#include "experiment/policy_reader.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

constexpr std::uint64_t seed = 1;

std::string data_text(const char* file) {
  const auto bytes = read_file_bytes(std::filesystem::path(FACET_TEST_DATA) / file);
  return {bytes.begin(), bytes.end()};
}

/// What two builds that run in turn are held to; these rows have no scores.
Policy latency_policy() {
  Policy policy = read_policy(FACET_CONFIGS "/gates/builds.yaml");
  policy.accuracy.clear();
  return policy;
}

/// The recorded runs by name, each as a run of data set "gate".
std::map<std::string, RunRecord> recorded() {
  const TimingTable table = timing_from_csv(data_text("samples.csv"));
  std::map<std::string, RunRecord> runs;
  for (TimingSample sample : table.samples) {
    RunRecord& run = runs[sample.dataset];
    run.timing.stages = table.stages;
    sample.dataset = "gate";
    if (run.timing.samples.empty() || run.timing.samples.back().frame != sample.frame) {
      FrameRow row;
      row.dataset = "gate", row.frame = sample.frame, row.method = sample.method;
      run.frames.push_back(row);
    }
    run.timing.samples.push_back(std::move(sample));
  }
  for (IoTime time : io_times_from_csv(data_text("io.csv"))) {
    RunRecord& run = runs.at(time.dataset);
    time.dataset = "gate";
    run.io_times.push_back(std::move(time));
  }
  return runs;
}

class GateReplay : public ::testing::Test {
 protected:
  /// The run again as it might have come out: the repeats of every frame drawn anew, with replacement.
  RunRecord drawn_anew(const RunRecord& run, std::uint64_t stream) const {
    RunRecord out = run;
    std::uint64_t draw = 0;
    for (std::size_t begin = 0, end = 0; begin < run.timing.samples.size(); begin = end) {
      while (end < run.timing.samples.size() &&
             run.timing.samples[end].frame == run.timing.samples[begin].frame)
        ++end;
      for (std::size_t i = begin; i < end; ++i)
        out.timing.samples[i] = run.timing.samples[begin + index_below(end - begin, stream, draw++)];
    }
    return out;
  }
  static std::size_t index_below(std::size_t count, std::uint64_t stream, std::uint64_t draw) {
    return std::min(count - 1,
                    static_cast<std::size_t>(random_uniform(seed, stream, draw) * static_cast<float>(count)));
  }
  /// The numbers of the runs in random order.
  static std::array<int, recorded_runs> shuffled(std::uint64_t stream) {
    std::array<int, recorded_runs> numbers{};
    for (int i = 0; i < recorded_runs; ++i) numbers[static_cast<std::size_t>(i)] = i;
    for (std::size_t i = numbers.size() - 1; i > 0; --i)
      std::swap(numbers[i], numbers[index_below(i + 1, stream, 1000000 + i)]);
    return numbers;
  }
  std::vector<RunRecord> rounds(bool slowed, std::span<const int> numbers, std::uint64_t stream) const {
    std::vector<RunRecord> out;
    for (const int number : numbers)
      out.push_back(drawn_anew(runs_.at(recorded_name(slowed, number)),
                               100 * stream + static_cast<std::uint64_t>(2 * number + slowed)));
    return out;
  }
  /// What `facet gate --binary` decides of five rounds of each build, confirmed by as many more.
  GateDecision gate_builds(bool slowed, std::uint64_t stream) const {
    const auto numbers = shuffled(stream), others = shuffled(stream + 5000);
    const auto compare = [&](const std::array<int, recorded_runs>& n, std::uint64_t s) {
      const std::span all(n);
      // The same build against itself: no run stands on both sides.
      return compare_rounds(rounds(false, all.first(5), s), rounds(slowed, all.last(5), s), policy_,
                            options_);
    };
    Comparison comparison = compare(numbers, stream);
    if (decide(comparison, policy_).result == GateResult::failed)
      confirm(comparison, compare(others, stream + 5000));
    return decide(comparison, policy_);
  }
  const std::map<std::string, RunRecord> runs_ = recorded();
  const Policy policy_ = latency_policy();
  const BootstrapOptions options_{.replicates = 2000};
};

TEST_F(GateReplay, OfTheSameBuildIsNeverRedInAHundred) {
  for (std::uint64_t replay = 0; replay < 100; ++replay) {
    const GateDecision decision = gate_builds(false, replay);
    EXPECT_EQ(decision.result, GateResult::passed)
        << replay << ": " << (decision.failures.empty() ? "" : decision.failures.front());
  }
}

TEST_F(GateReplay, OfAStoredRunAgainstAnotherOfTheSameBuildIsNeverRed) {
  for (int before = 0; before < recorded_runs; ++before)
    for (int after = 0; after < recorded_runs; ++after) {
      if (before == after) continue;
      const Comparison comparison =
          compare_rounds({&runs_.at(recorded_name(false, before)), 1},
                         {&runs_.at(recorded_name(false, after)), 1}, policy_, options_);
      const GateDecision decision = decide(comparison, policy_);
      EXPECT_EQ(decision.result, GateResult::passed)
          << before << " and " << after << ": "
          << (decision.failures.empty() ? "" : decision.failures.front());
    }
}

TEST_F(GateReplay, FindsAStageThatIsAFifthSlowerInNineOfTen) {
  int red = 0;
  for (std::uint64_t replay = 0; replay < 10; ++replay) {
    const GateDecision decision = gate_builds(true, 200 + replay);
    red += decision.result == GateResult::failed;
    for (const std::string& failure : decision.failures)
      EXPECT_EQ(failure.find("wiener"), std::string::npos) << "was not slowed: " << failure;
  }
  RecordProperty("red_of_ten", red);
  EXPECT_GE(red, 9);
}

TEST_F(GateReplay, TheSlowedStageIsAFifthOfTheWholeAtLeast) {
  double stage_ms = 0, total_ms = 0;
  for (int number = 0; number < recorded_runs; ++number)
    for (const TimingSample& sample : runs_.at(recorded_name(false, number)).timing.samples) {
      stage_ms += sample.stage_ms.front();
      total_ms += sample.total_ms;
    }
  EXPECT_GE(stage_ms, 0.2 * total_ms);
}

/// Takes 10 ms for one stage and 30 ms for all, by its own account.
class KnownMethod : public Method {
 public:
  void process(const Frame&, Prediction&, StageTimes& times) override {
    times = {};
    times.stage_ms[static_cast<std::size_t>(index_of(slowed_stage))] = 10;
    times.total_ms = 30;
  }
  void reset_history() override {}
};

TEST(SlowedMethod, AddsItsShareToOneStageAndToTheWhole) {
  SlowedMethod method(std::make_unique<KnownMethod>(), slowed_stage, 0.2);
  Prediction prediction;
  StageTimes times;
  method.process({}, prediction, times);
  const double stage_ms = times.stage_ms[static_cast<std::size_t>(index_of(slowed_stage))];
  EXPECT_GE(stage_ms, 12);
  EXPECT_NEAR(times.total_ms - stage_ms, 20, 1e-9);
  EXPECT_NEAR(times.unattributed_ms(), 20, 1e-9);
}

}  // namespace
}  // namespace facet
