#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiment/facet_process.hpp"
#include "experiment/small_frames.hpp"

namespace facet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string sweep_over(const std::string& axes) {
  return "schema: 1\n" + small_dataset + "sweep: {" + axes + "}\ntiming: {warmup: 1, repeats: 2}\n";
}

class SweepCommand : public ::testing::Test {
 protected:
  SweepCommand() { write_small_frames(facet.folder() / "frames", {"f0", "f1"}); }
  ProcessResult sweep(const std::string& axes) {
    facet.write("exp.yaml", sweep_over(axes));
    return facet.run({"sweep", "exp.yaml", "-o", "out"});
  }
  FacetProcess facet;
};

TEST_F(SweepCommand, RunsEveryCombinationAndStoresItsCurve) {
  const auto result = sweep("wiener.window_px: [3, 5], fill.enabled: [true, false]");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto run = facet.latest("out", "exp");
  const auto rows = nlohmann::json::parse(file_text(run / "timing/sweep.json")).at("rows");
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].at("settings"), (nlohmann::json{{"wiener.window_px", "3"}, {"fill.enabled", "true"}}));
  EXPECT_GT(rows[0].at("value").get<double>(), 0);
  EXPECT_THAT(result.out, HasSubstr("Sweep of method default on small"));
}

TEST_F(SweepCommand, WhatADataSetVariesIsAnAxisToo) {
  facet.write("spec.yaml",
              "schema: 1\nname: s\nsets: [{name: set, scenes: boxes, count: 1, vary: {noise: [0, 2]}}]\n");
  facet.write("exp.yaml",
              "schema: 1\ndatasets: [{name: set, reader: benchmark, root: spec.yaml, cache: cache}]\n"
              "sweep: {wiener.window_px: [3, 5]}\ntiming: {repeats: 0}\n");
  const auto result = facet.run({"sweep", "exp.yaml", "-o", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto rows =
      nlohmann::json::parse(file_text(facet.latest("out", "exp") / "metrics/sweep.json")).at("rows");
  std::map<std::string, std::vector<double>> levels;  // of recall, by point; -1: all frames
  for (const auto& row : rows)
    if (row.at("measure") == "surface_recall_0.5") {
      EXPECT_TRUE(row.at("value").is_number());
      EXPECT_EQ(row.at("axis"), row.at("level").is_null() ? "" : "noise");
      levels[row.at("method")].push_back(row.at("level").is_null() ? -1 : row.at("level").get<double>());
    }
  const std::vector<double> both{-1, 0, 2};
  EXPECT_EQ(levels, (std::map<std::string, std::vector<double>>{{"default.wiener.window_px-3", both},
                                                                {"default.wiener.window_px-5", both}}));
}

TEST_F(SweepCommand, TakesOverPointsThatWereComputed) {
  ASSERT_EQ(sweep("wiener.window_px: [3, 5]").exit_code, 0);
  const auto first = facet.latest("out", "exp");
  const auto second = sweep("wiener.window_px: [5, 7]");
  ASSERT_EQ(second.exit_code, 0) << second.err;
  EXPECT_THAT(second.err, HasSubstr("2 of 4 frames times points are those of earlier runs"));
  const auto run = facet.latest("out", "exp");
  ASSERT_NE(run, first);
  const std::string label = "predictions/default.wiener.window_px-5/small/f1.labels.png";
  EXPECT_EQ(file_text(run / label), file_text(first / label));
  const std::string log = file_text(run / "log.jsonl");
  EXPECT_THAT(log, HasSubstr("\"event\":\"kept\""));
  const std::string rows = file_text(run / "frames.jsonl"), curves = file_text(run / "metrics/sweep.json");
  std::filesystem::remove_all(facet.folder() / "out");
  ASSERT_EQ(sweep("wiener.window_px: [5, 7]").exit_code, 0);
  const auto fresh = facet.latest("out", "exp");
  EXPECT_EQ(rows, file_text(fresh / "frames.jsonl"));
  EXPECT_EQ(curves, file_text(fresh / "metrics/sweep.json"));
  EXPECT_THAT(file_text(fresh / "log.jsonl"), Not(HasSubstr("\"event\":\"kept\"")));
}

TEST_F(SweepCommand, RefusesAPointThatContradictsItself) {
  const auto result = sweep("cd.high_deg: [5, 25]");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("default.cd.high_deg-5"));
}

}  // namespace
}  // namespace facet
