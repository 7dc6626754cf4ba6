#include "compare/gate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <tinyxml2.h>

#include "compare/benchmark_json.hpp"
#include "compare/comparison_report.hpp"
#include "compare/runs.hpp"

namespace facet {
namespace {

using ::testing::HasSubstr;

const std::vector<int> good{8, 9, 8, 7, 9, 10, 8, 8}, bad{7, 8, 7, 6, 8, 9, 7, 7};

GateDecision gate(const Policy& policy, const RunRecord& before, const RunRecord& after) {
  return decide(compare_rounds({&before, 1}, {&after, 1}, policy, {.replicates = 1000}), policy);
}

Policy on_recall(const Rule& rule) {
  Policy policy;
  policy.accuracy["surface_recall_0.5"] = rule;
  return policy;
}

TEST(Gate, FailsWhereAHardRuleIsBroken) {
  EXPECT_EQ(gate(on_recall({}), run_with(good), run_with(bad)).result, GateResult::failed);
  EXPECT_EQ(gate(on_recall({}), run_with(good), run_with(good)).result, GateResult::passed);
}

TEST(Gate, WarnsWhereASoftRuleIsBroken) {
  const GateDecision soft = gate(on_recall({.hard = false}), run_with(good), run_with(bad));
  EXPECT_EQ(soft.result, GateResult::passed);
  ASSERT_EQ(soft.warnings.size(), 1u);
  EXPECT_THAT(soft.warnings[0], HasSubstr("surface_recall_0.5"));
}

TEST(Gate, FailsWhereARequiredMetricVanished) {
  Policy policy;
  policy.accuracy["edge_recall_all_6px"] = {.required = true};
  policy.accuracy["surface_recall_0.5"] = {};
  const GateDecision decision = gate(policy, run_with(good), run_with(good));
  EXPECT_EQ(decision.result, GateResult::failed);
  ASSERT_EQ(decision.failures.size(), 1u);
  EXPECT_THAT(decision.failures[0], HasSubstr("edge_recall_all_6px"));
}

TEST(Gate, IsNotMeasuredForTooFewSamples) {
  EXPECT_EQ(gate(on_recall({.least_n = 9}), run_with(good), run_with(good)).result, GateResult::not_measured);
}

TEST(Gate, LetsThePolicyDecideAboutInconclusive) {
  std::vector<int> one_worse = good;
  one_worse[0] = 5;
  Policy policy = on_recall({});
  EXPECT_EQ(gate(policy, run_with(good), run_with(one_worse)).result, GateResult::passed);
  policy.inconclusive_fails = true;
  EXPECT_EQ(gate(policy, run_with(good), run_with(one_worse)).result, GateResult::not_measured);
}

TEST(Gate, IsNotMeasuredWhereThePolicyNamesNothing) {
  EXPECT_EQ(gate({}, run_with(good), run_with(good)).result, GateResult::not_measured);
}

TEST(GateFiles, JunitHoldsAFailureForEveryRegression) {
  const RunRecord before = run_with(good), after = run_with(bad);
  const Policy policy = on_recall({});
  const Comparison comparison = compare_rounds({&before, 1}, {&after, 1}, policy, {.replicates = 1000});
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(junit_xml(comparison, decide(comparison, policy)).c_str()), tinyxml2::XML_SUCCESS);
  const auto* suite = document.FirstChildElement("testsuites")->FirstChildElement("testsuite");
  EXPECT_STREQ(suite->Attribute("name"), "m on d");
  const auto* test = suite->FirstChildElement("testcase");
  EXPECT_STREQ(test->Attribute("name"), "surface_recall_0.5");
  EXPECT_NE(test->FirstChildElement("failure"), nullptr);
}

TEST(GateFiles, AnnotationsKeepToOneLineEach) {
  EXPECT_EQ(github_annotations({GateResult::failed, {"5 % worse\nmuch"}, {"odd"}}),
            "::error title=facet gate::5 %25 worse%0Amuch\n::warning title=facet gate::odd\n");
}

TEST(GateFiles, BenchmarkShapesCarryEveryStage) {
  RunRecord run = run_with(good);
  add_times(run, 1, 1, 7);
  const auto action = nlohmann::json::parse(action_benchmark_json(run));
  ASSERT_EQ(action.size(), 3u);
  EXPECT_EQ(action[0].at("name"), "m/d/work");
  EXPECT_EQ(action[0].at("unit"), "ms");
  EXPECT_NEAR(action[0].at("value").get<double>(), 10.1, 0.15);
  const auto google = nlohmann::json::parse(google_benchmark_json(run));
  EXPECT_EQ(google.at("benchmarks").size(), 9u);
  EXPECT_EQ(google.at("benchmarks")[0].at("time_unit"), "ms");
}

}  // namespace
}  // namespace facet
