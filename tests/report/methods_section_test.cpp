#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/run_report.hpp"

namespace facet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

FrameRow scored_row(const std::string& frame, const std::string& method, int detected) {
  FrameRow row;
  row.dataset = "osd";
  row.frame = frame;
  row.method = method;
  row.truth_source = "annotations";
  FrameScore score;
  score.annotated = {.surfaces = true, .edges = true};
  score.predicted = {.edges = true, .poses = true, .grasps = true};
  score.surfaces_50.truth = 10;
  score.surfaces_50.detected = detected;
  score.edges.recall_6px.graspable = {detected, 10};
  row.score = score;
  return row;
}

/// Method `a` finds 8 of 10 surfaces of every frame, `b` 5, and `c` has no regions.
RunRecord run_of_three() {
  RunRecord run;
  run.manifest.methods = {"a", "b", "c"};
  run.manifest.datasets = {"osd"};
  for (const std::string frame : {"f1", "f2", "f3"}) {
    run.frames.push_back(scored_row(frame, "a", 8));
    run.frames.push_back(scored_row(frame, "b", 5));
    run.frames.push_back(scored_row(frame, "c", 2));
    run.frames.back().score->predicted.regions = false;
    for (const std::string method : {"a", "b"})
      run.timing.samples.push_back(
          {"osd", frame, method, TimingPhase::steady, 0, 0, 0, method == "a" ? 20.0 : 5.0, {}});
    run.io_times.push_back({"osd", frame, "c", "program", 300});
  }
  run.scores = score_results_from_json(metrics_summary_json(run.manifest, run.frames));
  return run;
}

std::vector<std::string> row_called(const ReportTable& table, const std::string& name) {
  for (const auto& row : table.rows)
    if (row[0] == name) return row;
  ADD_FAILURE() << "no row " << name;
  return {};
}

TEST(MethodsSection, EveryMethodHasAColumnWithItsPairedDifferenceToTheFirst) {
  const ReportSection section = methods_section(run_of_three());
  ASSERT_EQ(section.tables.size(), 1u);
  EXPECT_THAT(section.tables[0].header, ElementsAre("score", "a", "b", "c"));
  EXPECT_THAT(row_called(section.tables[0], "All surfaces, IoU 0.5"),
              ElementsAre("All surfaces, IoU 0.5", "80.0", "50.0; -30.0 [-30.0, -30.0]", "n/a"));
  EXPECT_THAT(row_called(section.tables[0], "Graspable edges, 6 px"),
              ElementsAre("Graspable edges, 6 px", "80.0", "50.0; -30.0 [-30.0, -30.0]",
                          "20.0; -60.0 [-60.0, -60.0]"));
  EXPECT_THAT(row_called(section.tables[0], "Time of a frame, median [ms]"),
              ElementsAre("Time of a frame, median [ms]", "20.0", "5.0", "300.0 (program)"));
}

TEST(MethodsSection, AccuracyStandsAgainstLatencyWhereBothAreKnown) {
  const ReportSection section = methods_section(run_of_three());
  ASSERT_FALSE(section.charts.empty());
  const auto& edges = std::get<XyChart>(section.charts.back().body);
  ASSERT_EQ(edges.series.size(), 3u);
  EXPECT_EQ(edges.series[1].points[0].x, 5);
  EXPECT_EQ(edges.series[1].points[0].y, 50);
  EXPECT_THAT(edges.series[2].name, HasSubstr("whole program"));
  EXPECT_THAT(chart_svg(section.charts.back()), StartsWith("<svg"));
}

TEST(MethodsSection, OneMethodAndAStudyHaveNone) {
  RunRecord run = run_of_three();
  run.sweep.emplace_back();
  EXPECT_TRUE(methods_section(run).tables.empty());
  run = run_of_three();
  run.manifest.methods = {"a"};
  EXPECT_TRUE(methods_section(run).tables.empty());
}

TEST(MethodsSection, DisputedFramesAreListedWithTheirPictures) {
  RunRecord run = run_of_three();
  EXPECT_TRUE(disputed_section(run).tables.empty());
  run.disputed = {{"osd", "f2", "a", "surface_f1_0.5", 0.8, 0.5, "gallery/disputed/osd/f2.png"}};
  const ReportSection section = disputed_section(run);
  ASSERT_EQ(section.pictures.size(), 1u);
  EXPECT_EQ(section.pictures[0].file, "gallery/disputed/osd/f2.png");
  EXPECT_THAT(section.tables[0].rows[0], ElementsAre("osd/f2", "surface_f1_0.5", "a", "0.800", "0.500"));
}

}  // namespace
}  // namespace facet
