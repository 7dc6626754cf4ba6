#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "record/csv.hpp"
#include "record/metrics_summary.hpp"
#include "record/score_json.hpp"
#include "score/metrics.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

/// A frame with `detected` of 4 surfaces found and one pose error.
FrameScore score_with(int detected) {
  FrameScore score;
  score.annotated = {.surfaces = true, .edges = true, .masks = false, .poses = true};
  score.predicted = {.edges = false, .poses = true, .grasps = false};
  score.surfaces_50 = {.truth = 4, .detected = detected, .wrong = 1, .iou_total = 0.8 * detected};
  score.hoover_curve[3].correct = 2;
  score.edges.recall_curve[9].convex = {1, 2};
  score.poses.errors.push_back({1, 2.5, 0.001, 0.002, 3});
  score.clutter = {.objects = 2, .surfaces = 4, .occluded_share = 0.25, .contacts = 1};
  return score;
}

FrameRow row_of(const std::string& frame, std::optional<FrameScore> score,
                FrameStatus status = FrameStatus::ok) {
  FrameRow row;
  row.dataset = "d";
  row.frame = frame;
  row.method = "m";
  row.status = status;
  row.truth_source = score ? "truth" : "";
  row.score = std::move(score);
  return row;
}

Manifest manifest() {
  Manifest m;
  m.methods = {"m"};
  m.datasets = {"d"};
  return m;
}

TEST(ScoreJson, ReadsBackWithEveryCount) {
  const nlohmann::json json = score_to_json(score_with(3));
  const FrameScore read = score_from_json(json);
  EXPECT_EQ(score_to_json(read), json);
  EXPECT_EQ(read.surfaces_50.detected, 3);
  EXPECT_EQ(read.hoover_curve[3].correct, 2);
  EXPECT_EQ(read.edges.recall_curve[9].convex, (Tally{1, 2}));
  EXPECT_EQ(read.poses.errors.at(0).normal_deg, 2.5);
  EXPECT_EQ(read.clutter.occluded_share, 0.25);
}

TEST(ScoreJson, APartThatIsAbsentIsAnError) {
  nlohmann::json json = score_to_json(score_with(3));
  json.erase("clutter");
  EXPECT_THROW(score_from_json(json), nlohmann::json::exception);
}

TEST(FrameRow, KeepsItsScore) {
  const FrameRow row = row_of("f", score_with(2));
  EXPECT_EQ(to_json_line(frame_row_from_json(to_json_line(row))), to_json_line(row));
  EXPECT_FALSE(frame_row_from_json(to_json_line(row_of("f", std::nullopt))).score.has_value());
}

TEST(FrameRow, ItsTableHasAColumnForEveryMetric) {
  const auto rows = parse_csv(frames_csv({row_of("f", score_with(3)), row_of("g", std::nullopt)}));
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin());
  };
  for (const Metric& metric : score_metrics()) ASSERT_LT(column(metric.name), rows[0].size()) << metric.name;
  EXPECT_EQ(rows[1][column("surface_recall_0.5")], "0.75");
  EXPECT_EQ(rows[1][column("edge_recall_all_6px")], "") << "not provided, which is not 0";
  EXPECT_EQ(rows[2][column("surface_recall_0.5")], "");
}

TEST(MetricsSummary, PoolsFramesAndCountsThoseThatAreNotScored) {
  const std::vector<FrameRow> rows{row_of("a", score_with(4)), row_of("b", score_with(2)),
                                   row_of("c", std::nullopt),
                                   row_of("e", std::nullopt, FrameStatus::data_error)};
  const auto results = score_results_from_json(metrics_summary_json(manifest(), rows));
  ASSERT_EQ(results.size(), 1u);
  const ScoreResult& result = results[0];
  const std::map<std::string, int> expected{
      {"n_total", 4},         {"n_scored", 2},       {"n_method_failed", 0},   {"n_harness_error", 1},
      {"n_not_annotated", 1}, {"surfaces_found", 0}, {"surfaces_with_pose", 0}};
  EXPECT_EQ(result.counts, expected);
  EXPECT_EQ(result.truth_sources.at("truth"), 2);
  const ScoreCell& recall = result.cell("surface_recall_0.5");
  EXPECT_EQ(recall.hit, 6);
  EXPECT_EQ(recall.n, 8);
  EXPECT_EQ(recall.value, 0.75);
  EXPECT_LT(*recall.lo, 0.75);
  EXPECT_EQ(result.macro.at("surface_recall_0.5").value, 0.75);
  EXPECT_EQ(result.cell("edge_recall_all_6px").reason, "the predictions have no edges");
  EXPECT_EQ(result.errors.at("normal_error_deg").p50, 2.5);
  EXPECT_FALSE(result.strata.empty());
}

TEST(MetricsSummary, AFailedFrameKeepsTheDenominator) {
  FrameScore failed = score_with(0);
  failed.failed = true;
  const std::vector<FrameRow> rows{row_of("a", score_with(4)),
                                   row_of("b", failed, FrameStatus::method_error)};
  const auto results = score_results_from_json(metrics_summary_json(manifest(), rows));
  EXPECT_EQ(results[0].counts.at("n_method_failed"), 1);
  EXPECT_EQ(results[0].cell("surface_recall_0.5").n, 8);
}

TEST(MetricsSummary, LeavesOutGroupsThatAreNotWanted) {
  const std::vector<FrameRow> rows{row_of("a", score_with(4))};
  const auto results =
      score_results_from_json(metrics_summary_json(manifest(), rows, {.edges = false, .poses = false}));
  EXPECT_TRUE(results[0].micro.contains("surface_recall_0.5"));
  EXPECT_FALSE(results[0].micro.contains("edge_recall_all_6px"));
  EXPECT_FALSE(results[0].micro.contains("pose_auc"));
  EXPECT_TRUE(results[0].errors.empty());
}

TEST(MetricsSummary, WithoutTruthThereAreCountsAndAReason) {
  const auto text = metrics_summary_json(manifest(), {row_of("a", std::nullopt)});
  EXPECT_THAT(text, ::testing::HasSubstr("no frame has truth"));
  EXPECT_TRUE(score_results_from_json(text)[0].micro.empty());
  expect_error(ErrorKind::data, "no summary of metrics", [] { score_results_from_json("{}"); });
}

}  // namespace
}  // namespace facet
