#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/run_report.hpp"

namespace facet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

FrameRow scored_row(const std::string& method, int edges_found) {
  FrameRow row;
  row.dataset = "osd";
  row.frame = "learn6";
  row.method = method;
  row.truth_source = "annotations";
  FrameScore score;
  score.annotated = {.surfaces = true, .edges = true, .masks = true, .poses = false};
  score.predicted = {.edges = true, .poses = true, .grasps = false};
  score.grasps.surfaces = {3, 4};
  score.grasps.objects_grasp = {0, 2};
  score.grasps.objects_pose = {1, 2};
  score.edges.recall_6px.graspable = {edges_found, 12};
  row.score = score;
  return row;
}

RunRecord scored_run() {
  RunRecord run;
  run.manifest.methods = {"a", "b"};
  run.manifest.datasets = {"osd"};
  run.frames = {scored_row("a", 11), scored_row("b", 5)};
  run.scores = score_results_from_json(metrics_summary_json(run.manifest, run.frames));
  return run;
}

const std::vector<std::string>& row_called(const ReportTable& table, const std::string& name) {
  for (const auto& row : table.rows)
    if (row[0] == name) return row;
  throw std::runtime_error("no row " + name);
}

TEST(DetectionSection, SetsEveryMethodBesideThePaper) {
  const ReportSection section = detection_section(scored_run());
  ASSERT_EQ(section.tables.size(), 2u);
  const ReportTable& table = section.tables[0];
  EXPECT_THAT(table.header, ElementsAre("what", "a", "b", "paper, other data", "[19], other data"));
  EXPECT_THAT(row_called(table, "Graspable edges, 6 px"),
              ElementsAre("Graspable edges, 6 px", "11/12 91.7 %", "5/12 41.7 %", "225/229 98.3 %",
                          "178/229 77.7 %"));
  EXPECT_EQ(row_called(table, "Objects with pose and grasp")[1], "n/a");
  EXPECT_EQ(row_called(table, "Objects with pose")[1], "1/2 50.0 %");
  EXPECT_EQ(row_called(table, "  scored")[1], "1");
}

TEST(DetectionSection, SaysWhyAScoreIsAbsentAndWhereTheTruthIsFrom) {
  const ReportTable table = detection_section(scored_run()).tables[0];
  EXPECT_THAT(table.notes, ::testing::Contains("Truth of 1 frame: annotations."));
  EXPECT_THAT(table.notes, ::testing::Contains("n/a, a: the predictions have no grasps."));
}

TEST(DetectionSection, HasTheLayoutOfTable2FrameByFrame) {
  const ReportTable table = detection_section(scored_run()).tables[1];
  EXPECT_THAT(table.header,
              ElementsAre("frame", "objects", "a", "b", "surfaces", "a", "b", "edges", "a", "b"));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_THAT(table.rows[0], ElementsAre("learn6", "2", "1", "1", "4", "3", "3", "12", "11", "5"));
  EXPECT_THAT(table.rows[1],
              ElementsAre("all", "2", "50.0 %", "50.0 %", "4", "75.0 %", "75.0 %", "12", "91.7 %", "41.7 %"));
}

TEST(PaperTable2, ListsFramesByKindAndThoseWithoutTruthAsSuch) {
  RunRecord run = scored_run();
  for (FrameRow& row : run.frames) row.kind = "2 Mixed";
  FrameRow bare = run.frames[0];
  bare.frame = "test2";
  bare.kind = "1 Boxes";
  bare.score.reset();
  run.frames.push_back(bare);
  const ReportTable table = table2_of_paper(run, "osd");
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_THAT(table.rows[0], ElementsAre("test2", "1 Boxes", "no truth", "no truth", "not run", "no truth",
                                         "no truth", "not run", "no truth", "no truth", "not run"));
  EXPECT_EQ(table.rows[1][0], "learn6");
  EXPECT_EQ(table.rows[2][2], "2");  // sums are of the frames with truth
}

TEST(DetectionSection, WithoutTruthItSaysSo) {
  RunRecord run = scored_run();
  for (FrameRow& row : run.frames) row.score.reset();
  run.scores = score_results_from_json(metrics_summary_json(run.manifest, run.frames));
  EXPECT_THAT(detection_section(run).paragraphs, ElementsAre("Not scored: no frame has truth."));
  EXPECT_THAT(score_detail_section(run).paragraphs, ElementsAre("Not scored."));
}

TEST(ScoreDetailSection, ListsEveryScoreWithIntervalAndMean) {
  const ReportSection section = score_detail_section(scored_run());
  ASSERT_FALSE(section.tables.empty());
  const auto& row = row_called(section.tables[0], "edge_recall_graspable_6px");
  EXPECT_THAT(row[1], HasSubstr("91.7 ["));
  EXPECT_THAT(row[1], HasSubstr("/ 91.7"));
}

TEST(ScoreDetailSection, StratifiesByClutter) {
  const ReportSection section = score_detail_section(scored_run());
  const ReportTable& table = section.tables.back();
  EXPECT_THAT(table.caption, HasSubstr("edge_recall_graspable_6px by clutter on osd"));
  ASSERT_FALSE(table.rows.empty());
  EXPECT_EQ(table.rows[0][1], "1");
}

}  // namespace
}  // namespace facet
