#include "study/ablation_effects.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace facet {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

FrameRow row(const std::string& method, int frame, int found) {
  FrameRow out;
  out.dataset = "d";
  out.method = method;
  out.frame = std::to_string(frame);
  out.score.emplace();
  out.score->annotated.surfaces = true;
  out.score->surfaces_50 = {.truth = 10, .detected = found};
  return out;
}

AblationPlan plan_of(const std::vector<AblationComparison>& comparisons) {
  return {{}, comparisons};
}

AblationComparison comparison(const std::string& name,
                              const std::vector<std::pair<std::string, std::string>>& pairs) {
  AblationComparison out;
  out.base = "default";
  out.switch_name = name;
  out.pairs = pairs;
  out.metrics = {"surface_recall_0.5"};
  return out;
}

TEST(AblationEffects, AreDifferencesOfPooledValues) {
  std::vector<FrameRow> rows;
  for (int i = 0; i < 12; ++i) {
    rows.push_back(row("on", i, 9));
    rows.push_back(row("off", i, i % 2 == 0 ? 5 : 7));
  }
  const auto effects = ablation_effects(plan_of({comparison("s", {{"on", "off"}})}), rows, {"d"});
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_NEAR(*effects[0].change, 0.3, 1e-12);
  EXPECT_LT(*effects[0].lo, 0.3);
  EXPECT_GT(*effects[0].lo, 0.2);
  EXPECT_EQ(effects[0].n, 12);
  EXPECT_LT(*effects[0].p_holm, 0.01);
}

TEST(AblationEffects, AverageOverThePairsOfAFactorialDesign) {
  std::vector<FrameRow> rows;
  for (int i = 0; i < 3; ++i)
    for (const auto& [method, found] :
         {std::pair{"a", 9}, std::pair{"b", 8}, std::pair{"c", 6}, std::pair{"d", 3}})
      rows.push_back(row(method, i, found));
  const auto effects = ablation_effects(plan_of({comparison("s", {{"a", "b"}, {"c", "d"}})}), rows, {"d"});
  EXPECT_NEAR(*effects[0].change, (0.1 + 0.3) / 2, 1e-12);
}

TEST(AblationEffects, TellZeroFromNotApplicable) {
  std::vector<FrameRow> rows;
  for (int i = 0; i < 4; ++i) rows.push_back(row("on", i, 9)), rows.push_back(row("off", i, 9));
  AblationComparison inert = comparison("inert", {});
  inert.not_applicable = "it needs fill";
  AblationComparison temporal = comparison("temporal", {{"on", "off"}});
  temporal.sequences_only = true;
  const auto effects =
      ablation_effects(plan_of({comparison("equal", {{"on", "off"}}), inert, temporal}), rows, {"d"});
  EXPECT_EQ(effects[0].change, 0.0);
  EXPECT_EQ(effects[0].reason, "no frame differs");
  EXPECT_FALSE(effects[1].change);
  EXPECT_EQ(effects[1].reason, "it needs fill");
  EXPECT_FALSE(effects[2].change);
  EXPECT_EQ(effects[2].reason, "not a sequence");
}

TEST(AblationCosts, AreDifferencesOfTheTotalPerFrame) {
  RunRecord run;
  run.manifest.datasets = {"d"};
  run.timing.stages = {"work"};
  for (int i = 0; i < 5; ++i) {
    for (const auto& [method, ms] : {std::pair{"on", 12.0}, std::pair{"off", 9.0}}) {
      run.frames.push_back(row(method, i, 9));
      TimingSample sample{"d", std::to_string(i), method};
      sample.total_ms = ms + i;
      sample.stage_ms = {ms + i};
      run.timing.samples.push_back(sample);
    }
  }
  const auto costs = ablation_costs(plan_of({comparison("s", {{"on", "off"}})}), run);
  ASSERT_EQ(costs.size(), 1u);
  EXPECT_NEAR(*costs[0].change, 3, 1e-9);
  EXPECT_EQ(costs[0].measure, "total_ms");
  EXPECT_EQ(ablation_from_json(ablation_to_json(costs)).at(0).change, costs[0].change);
}

TEST(Holm, AdjustsAsInTheTextbook) {
  EXPECT_THAT(holm({0.01, 0.04, 0.03, 0.005}), ElementsAre(DoubleNear(0.03, 1e-12), DoubleNear(0.06, 1e-12),
                                                           DoubleNear(0.06, 1e-12), DoubleNear(0.02, 1e-12)));
}

}  // namespace
}  // namespace facet
