#include "compare/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/runs.hpp"

namespace facet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Comparison compare(const RunRecord& before, const RunRecord& after,
                   const Policy& policy = comparing_policy()) {
  return compare_rounds({&before, 1}, {&after, 1}, policy, {.replicates = 1000});
}

const ComparedValue& value_of(const Comparison& comparison, const std::string& name) {
  for (const ComparedValue& value : comparison.values)
    if (value.name == name) return value;
  throw std::out_of_range(name);
}

std::vector<int> twenty(int found) {
  return std::vector<int>(20, found);
}

TEST(Comparison, OfARunWithItselfIsOkEverywhere) {
  RunRecord run = run_with({3, 5, 9, 10, 7, 8});
  add_times(run, 1, 1, 7);
  const Comparison comparison = compare(run, run);
  EXPECT_THAT(comparison.vanished, IsEmpty());
  EXPECT_GT(comparison.values.size(), 5u);
  for (const ComparedValue& value : comparison.values) EXPECT_EQ(value.verdict, Verdict::ok) << value.name;
}

TEST(Comparison, FindsALossOfOneSurfaceInEveryFrame) {
  const Comparison comparison = compare(run_with(twenty(8)), run_with(twenty(7)));
  const ComparedValue& recall = value_of(comparison, "surface_recall_0.5");
  EXPECT_EQ(recall.verdict, Verdict::regressed);
  EXPECT_DOUBLE_EQ(*recall.before, 0.8);
  EXPECT_NEAR(*recall.change, -0.1, 1e-12);
  EXPECT_EQ(recall.n, 20);
}

TEST(Comparison, LeavesALossInOneFrameOfTwentyOpenUnlessScoresAreExact) {
  std::vector<int> one_worse = twenty(8);
  one_worse[4] = 6;
  EXPECT_EQ(value_of(compare(run_with(twenty(8)), run_with(one_worse)), "surface_recall_0.5").verdict,
            Verdict::inconclusive);
  Policy exact;
  exact.accuracy["surface_recall_0.5"] = {.exact = true};
  EXPECT_EQ(compare(run_with(twenty(8)), run_with(one_worse), exact).values.at(0).verdict,
            Verdict::regressed);
}

TEST(Comparison, NamesWhatVanished) {
  const RunRecord before = run_with({8, 8, 8});
  EXPECT_THAT(compare(before, run_with({8, 8})).vanished, ElementsAre("m on d: frame f2"));
  RunRecord unscored = before;
  unscored.frames[1].score.reset();
  EXPECT_THAT(compare(before, unscored).vanished, ElementsAre("m on d: score of frame f1"));
  RunRecord renamed = before;
  for (FrameRow& row : renamed.frames) row.method = "other";
  EXPECT_THAT(compare(before, renamed).vanished, ElementsAre("method m on data set d"));
  RunRecord timed = before;
  add_times(timed, 1, 1, 7);
  EXPECT_THAT(compare(timed, before).vanished,
              ElementsAre("work of m on d", "rest of m on d", "total of m on d"));
}

TEST(Comparison, RefusesFramesWithOtherInput) {
  RunRecord after = run_with({8, 8, 9});
  after.frames[2].input_hash = "another file";
  const Comparison comparison = compare(run_with({8, 8, 8}), after);
  EXPECT_EQ(value_of(comparison, "surface_recall_0.5").verdict, Verdict::not_comparable);
  EXPECT_THAT(value_of(comparison, "surface_recall_0.5").reason, HasSubstr("1 of 3 frames"));
}

TEST(Comparison, TakesTheMachineOutOfTimes) {
  RunRecord before = run_with(twenty(8)), after = before;
  add_times(before, 1, 1, 7);
  add_times(after, 1.2, 3, 8);
  const Comparison comparison = compare(before, after);
  EXPECT_EQ(value_of(comparison, "work").verdict, Verdict::regressed);
  EXPECT_NEAR(*value_of(comparison, "work").after, 12, 0.3);
  EXPECT_EQ(value_of(comparison, "rest").verdict, Verdict::ok);
}

TEST(Comparison, DoesNotCompareTimesOfAnotherMachineWithoutCalibration) {
  RunRecord before = run_with(twenty(8)), after = before;
  add_times(before, 1, 1, 7);
  add_times(after, 1, 1, 8);
  before.environment = {{"cpu.model", "one"}};
  after.environment = {{"cpu.model", "another"}};
  EXPECT_EQ(value_of(compare(before, after), "total").verdict, Verdict::ok);
  after.io_times.clear();
  EXPECT_EQ(value_of(compare(before, after), "total").verdict, Verdict::not_comparable);
}

TEST(Comparison, DoesNotCompareTimesOfAnotherBackEndOrAnotherDevice) {
  RunRecord before = run_with(twenty(8)), after = before;
  add_times(before, 1, 1, 7);
  add_times(after, 1, 1, 8);
  before.manifest.backend = "cpu";
  after.manifest.backend = "cuda";
  const ComparedValue across = value_of(compare(before, after), "total");
  EXPECT_EQ(across.verdict, Verdict::not_comparable);
  EXPECT_EQ(across.reason, "back ends cpu and cuda");
  before.manifest.backend = "cuda";
  before.environment = after.environment = {{"gpu.device", "one"}};
  EXPECT_EQ(value_of(compare(before, after), "total").verdict, Verdict::ok);
  after.environment = {{"gpu.device", "another"}};
  EXPECT_EQ(value_of(compare(before, after), "total").reason, "gpu.device: one and another");
}

TEST(Comparison, DoubtsTheTimesOfABusyMachine) {
  RunRecord before = run_with(twenty(8)), after = before;
  add_times(before, 1, 1, 7);
  add_times(after, 1.3, 1, 8);
  for (std::size_t i = 0; i < after.timing.samples.size(); i += 2) after.timing.samples[i].stage_ms[0] *= 1.5;
  const ComparedValue work = value_of(compare(before, after), "work");
  EXPECT_EQ(work.verdict, Verdict::inconclusive);
  EXPECT_THAT(work.reason, HasSubstr("busy"));
}

TEST(Comparison, OfRoundsCarriesTheirScatter) {
  // One round is slower by a tenth: over five rounds that is no proof.
  std::vector<RunRecord> before, after;
  for (std::uint64_t round = 0; round < 5; ++round) {
    before.push_back(run_with(twenty(8)));
    after.push_back(run_with(twenty(8)));
    add_times(before.back(), 1, 1, 10 + round);
    add_times(after.back(), round == 2 ? 1.5 : 1, 1, 20 + round);
  }
  const Comparison comparison = compare_rounds(before, after, comparing_policy(), {.replicates = 1000});
  EXPECT_EQ(value_of(comparison, "work").verdict, Verdict::inconclusive);
  EXPECT_EQ(value_of(comparison, "work").n, 100);
}

TEST(Comparison, ConfirmsASlowdownOnlyByASecondOne) {
  RunRecord before = run_with(twenty(8)), slow = before, same = before;
  add_times(before, 1, 1, 7);
  add_times(slow, 1.3, 1, 8);
  add_times(same, 1, 1, 9);
  Comparison twice = compare(before, slow), once = compare(before, slow);
  confirm(twice, compare(before, slow));
  EXPECT_EQ(value_of(twice, "work").verdict, Verdict::regressed);
  confirm(once, compare(before, same));
  EXPECT_EQ(value_of(once, "work").verdict, Verdict::inconclusive);
}

}  // namespace
}  // namespace facet
