#include "report/timing_summary.hpp"

#include <gtest/gtest.h>
#include <set>

#include "pipeline/stage_id.hpp"

namespace facet {
namespace {

TimingTable table_of(int frames, int repeats) {
  TimingTable table;
  for (const StageName& stage : stage_names) table.stages.emplace_back(stage.key);
  for (int f = 0; f < frames; ++f) {
    for (int r = 0; r < repeats; ++r) {
      TimingSample sample{"d", std::string("f").append(std::to_string(f)), "m"};
      sample.phase = f == 0 && r == 0 ? TimingPhase::first : TimingPhase::steady;
      sample.surfaces = f + 1;
      sample.posed = 2;
      sample.stage_ms.assign(stage_names.size(), 1.0);
      sample.total_ms = 20 + f;
      table.samples.push_back(sample);
    }
  }
  return table;
}

TEST(Table3, EveryStageOfThePipelineStandsInExactlyOneRow) {
  std::multiset<std::string_view> rows, parts;
  for (const TimingRowLayout& row : table3_layout()) {
    for (const std::string_view stage : row.stages) (row.indented ? parts : rows).insert(stage);
  }
  for (const StageName& stage : stage_names) {
    if (stage.id >= StageId::pose) continue;  // the paper gives it apart, and so do the totals
    EXPECT_EQ(rows.count(stage.key), 1u) << stage.key;
  }
  EXPECT_EQ(rows.size(), stage_names.size() - 2);
  for (const std::string_view part : parts) EXPECT_EQ(rows.count(part), 1u) << part;
}

TEST(Table3, ThePapersStagesSumToWhatItsTableSays) {
  double sum = 0;
  for (const TimingRowLayout& row : table3_layout())
    if (row.paper) sum += row.paper->mean_ms;
  EXPECT_NEAR(sum, 11.18, 1e-9);
}

TEST(TimingSummary, StagesAndUnattributedRestSumToTheTotal) {
  const auto all = summarize_timing(table_of(3, 10));
  ASSERT_EQ(all.size(), 1u);
  const TimingSummary& s = all[0];
  double sum = s.unattributed.mean_ms;
  for (const NamedTimes& stage : s.stages) sum += stage.times.mean_ms;
  EXPECT_NEAR(sum, s.total.mean_ms, 1e-9);
  EXPECT_NEAR(s.total_without_pose.mean_ms, s.total.mean_ms - 2, 1e-9);  // pose and grasps
  EXPECT_NEAR(*s.pose_per_surface_ms, 0.5, 1e-12);
}

TEST(TimingSummary, AMethodWithoutStagesHasATotalAlone) {
  TimingTable table = table_of(3, 10);
  for (TimingSample& sample : table.samples) sample.stage_ms.clear();
  const TimingTable read = timing_from_csv(to_csv(table));
  EXPECT_TRUE(read.samples[0].stage_ms.empty());
  const TimingSummary s = summarize_timing(read)[0];
  EXPECT_EQ(s.total.n, 29);
  EXPECT_EQ(s.unattributed.n, 0);
  EXPECT_EQ(s.pose.n, 0);
  for (const NamedTimes& stage : s.stages) EXPECT_EQ(stage.times.n, 0) << stage.name;
}

TEST(TimingSummary, TheFirstRunIsNotAmongTheSteadyOnes) {
  const auto s = summarize_timing(table_of(3, 10))[0];
  EXPECT_EQ(s.total.n, 29);
  EXPECT_EQ(*s.first_ms, 20);
}

TEST(TimingSummary, RepeatsAndFramesAreToldApartAndTheSlopeIsFound) {
  const auto s = summarize_timing(table_of(3, 10))[0];
  EXPECT_NEAR(s.repeat_deviation_ms, 0, 1e-12);
  EXPECT_NEAR(*s.frame_deviation_ms, 1, 1e-12);
  ASSERT_TRUE(s.by_surfaces);
  EXPECT_NEAR(s.by_surfaces->slope, 1, 1e-9);
  EXPECT_FALSE(summarize_timing(table_of(2, 10))[0].by_surfaces);
}

TEST(TimingSummary, PercentilesNeedEnoughSamples) {
  const auto at = [](std::size_t n) { return summarize_times(std::vector<double>(n, 1.0)).percentile_ms; };
  EXPECT_FALSE(at(5)[0]);
  EXPECT_TRUE(at(6)[0]);
  EXPECT_FALSE(at(63)[1]);
  EXPECT_TRUE(at(64)[1]);
  EXPECT_FALSE(at(129)[2]);
  EXPECT_TRUE(at(130)[2]);
  EXPECT_FALSE(at(661)[3]);
  EXPECT_TRUE(at(662)[3]);
}

TEST(TimingSummary, DeadlineMissesCountTimesOverTheDeadline) {
  const auto times = summarize_times(std::vector<double>{30.0, 30.1, 33.3, 33.4});
  EXPECT_EQ(times.deadline_misses[0], 3);
  EXPECT_EQ(times.deadline_misses[1], 1);
}

TEST(TimingSummary, NoSamplesGiveNoSummary) {
  EXPECT_TRUE(summarize_timing({}).empty());
}

}  // namespace
}  // namespace facet
