#include "report/chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "report/run_report.hpp"

namespace facet {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(AxisTicks, AreRoundAndCoverTheData) {
  EXPECT_THAT(axis_ticks(0, 97, 5), ElementsAre(0, 20, 40, 60, 80, 100));
  EXPECT_THAT(axis_ticks(-0.3, 0.2, 5),
              ElementsAre(DoubleNear(-0.3, 1e-9), DoubleNear(-0.2, 1e-9), DoubleNear(-0.1, 1e-9),
                          DoubleNear(0, 1e-9), DoubleNear(0.1, 1e-9), DoubleNear(0.2, 1e-9)));
  EXPECT_THAT(axis_ticks(3, 3, 5), ElementsAre(3));
}

TEST(LogarithmicTicks, CoverTheDataWithOnesTwosAndFivesOrWithPowersOfTenAlone) {
  EXPECT_THAT(logarithmic_ticks(0.1, 4),
              ElementsAre(DoubleNear(0.1, 1e-9), DoubleNear(0.2, 1e-9), DoubleNear(0.5, 1e-9),
                          DoubleNear(1, 1e-9), DoubleNear(2, 1e-9), DoubleNear(5, 1e-9)));
  EXPECT_THAT(logarithmic_ticks(0.01, 40),
              ElementsAre(DoubleNear(0.01, 1e-9), DoubleNear(0.1, 1e-9), DoubleNear(1, 1e-9),
                          DoubleNear(10, 1e-9), DoubleNear(100, 1e-9)));
}

ReportChart example_chart() {
  XyChart body;
  body.x = {"surfaces <n>", {}, {}};
  body.y = {"time [ms]", 0, {}};
  body.series = {{"a & b", 0, true, true, {{1, 10, 8, 12, "frame 1: 10 ms"}, {2, 20, {}, {}, {}}}}};
  return {"Times", body, {}};
}

TEST(ChartSvg, HasAxesWithUnitsALegendAndValuesToPointAt) {
  const std::string svg = chart_svg(example_chart());
  EXPECT_THAT(svg, HasSubstr("time [ms]"));
  EXPECT_THAT(svg, HasSubstr("surfaces &lt;n&gt;"));
  EXPECT_THAT(svg, HasSubstr("a &amp; b"));
  EXPECT_THAT(svg, HasSubstr("<title>frame 1: 10 ms</title>"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(ChartSvg, AChartOfOnePointAndOneWithoutAnyAreDrawnToo) {
  ReportChart chart = example_chart();
  auto& body = std::get<XyChart>(chart.body);
  body.series[0].points.resize(1);
  EXPECT_THAT(chart_svg(chart), Not(HasSubstr("nan")));
  body.series.clear();
  EXPECT_THAT(chart_svg(chart), Not(HasSubstr("nan")));
}

TEST(ChartSvg, ARangeBelowTheLowestOfALogarithmicAxisStandsAtIt) {
  RangeChart body;
  body.axis = {"time [ms]", 0.01, {}, true};
  body.rows = {{"Fill", {{0, 0, 0, 5, 0, 1, "Fill: 0 ms"}}}};
  const std::string svg = chart_svg({"Times", body, {}});
  EXPECT_THAT(svg, HasSubstr("Fill: 0 ms"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

/// Frames whose times grow by 2 ms per surface and whose recall is the same.
RunRecord cluttered_run() {
  RunRecord run;
  run.manifest.methods = {"m"};
  run.manifest.datasets = {"d"};
  run.timing.stages = {"pose"};
  for (int i = 1; i <= 5; ++i) {
    FrameRow row;
    row.dataset = "d";
    row.method = "m";
    row.frame = std::to_string(i);
    row.axis = "noise";
    row.level = i;
    row.score = FrameScore{};
    row.score->annotated.surfaces = true;
    row.score->clutter.surfaces = i;
    row.score->surfaces_50.truth = 4;
    row.score->surfaces_50.detected = 3;
    run.frames.push_back(row);
    run.timing.samples.push_back({"d", row.frame, "m", TimingPhase::steady, 0, 9, 9, 11.0 + 2 * i, {1.0}});
  }
  return run;
}

const std::vector<std::string>* row_starting(const ReportSection& section, const std::string& name) {
  for (const ReportTable& table : section.tables)
    for (const auto& row : table.rows)
      if (row[0].starts_with(name)) return &row;
  return nullptr;
}

TEST(ClutterSection, SlopesAreTakenOverTheSurfacesOfTheTruth) {
  const ReportSection section = clutter_section(cluttered_run());
  const auto* time = row_starting(section, "Segmentation time [ms per surface]");
  ASSERT_NE(time, nullptr);
  EXPECT_EQ((*time)[1], "+2.000 [+2.000, +2.000], n = 5");
  const auto* recall = row_starting(section, "Surface recall [points per surface]");
  ASSERT_NE(recall, nullptr);
  EXPECT_EQ((*recall)[1], "+0.000 [+0.000, +0.000], n = 5");
}

TEST(CurveSection, IsDrawnFromTheStoredCountsOfFrames) {
  RunRecord run = cluttered_run();
  for (FrameRow& row : run.frames) row.score->hoover_curve[0] = {.truth = 4, .predicted = 4, .correct = 1};
  const ReportSection section = curve_section(run);
  ASSERT_FALSE(section.charts.empty());
  const auto& body = std::get<XyChart>(section.charts[0].body);
  EXPECT_DOUBLE_EQ(body.series[0].points[0].y, 25);
}

TEST(LevelSection, HasOnePointPerLevel) {
  const ReportSection section = level_section(cluttered_run());
  ASSERT_FALSE(section.charts.empty());
  EXPECT_EQ(std::get<XyChart>(section.charts[0].body).series[0].points.size(), 5u);
  EXPECT_EQ(section.tables[0].rows[0][1], "3/4 75.0 %");
}

}  // namespace
}  // namespace facet
