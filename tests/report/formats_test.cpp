#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "record/csv.hpp"
#include "report/document.hpp"
#include "report/write_report.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Report example() {
  ReportTable table{
      "Times, \"all\"", {"stage", "50 % & more_"}, {{"  of DD", "1.0 ± 0.1"}}, {"a [note]"}, ""};
  ReportSection section;
  section.title = "Timing";
  section.tables = {table};
  RangeChart chart;
  chart.axis.label = "time [ms]";
  chart.rows = {{"DD", {{0, 1, 2, 3, {}, {}, {}}}}};
  section.charts = {{"Chart", chart, {}}};
  return {"Title", {section}};
}

TEST(RenderCsv, HasALinePerCellThatReadsBack) {
  const auto rows = parse_csv(render_csv(example()));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_THAT(rows[1], ElementsAre("Timing", "Times, \"all\"", "of DD", "50 % & more_", "1.0 ± 0.1"));
}

TEST(RenderJson, ReadBackIsTheSameButForCharts) {
  Report report = example();
  for (ReportSection& section : report.sections) section.charts.clear();
  EXPECT_EQ(render_json(report_from_json(render_json(report), "x")), render_json(report));
  expect_error(ErrorKind::data, "x: is no report", [] { report_from_json("{}", "x"); });
}

TEST(RenderJson, HoldsTablesAndTheDataOfCharts) {
  const auto json = nlohmann::json::parse(render_json(example()));
  EXPECT_EQ(json["sections"][0]["tables"][0]["rows"][0][1], "1.0 ± 0.1");
  EXPECT_EQ(json["sections"][0]["charts"][0]["rows"][0]["middle"], 2);
  EXPECT_TRUE(json["sections"][0]["charts"][0]["rows"][0]["box_low"].is_null());
}

TEST(LatexTable, WhatLatexGivesAMeaningIsEscaped) {
  const std::string latex = latex_table(example().sections[0].tables[0]);
  EXPECT_THAT(latex, HasSubstr("50 \\% \\& more\\_"));
  EXPECT_THAT(latex, HasSubstr("\\quad of DD & 1.0 $\\pm$ 0.1 \\\\"));
  EXPECT_THAT(latex, HasSubstr("a {[}note{]}"));
  EXPECT_THAT(latex, HasSubstr("\\begin{tabular}{lr}"));
}

TEST(WriteReport, AnUnknownFormatIsAnErrorThatNamesTheKnownOnes) {
  expect_error(ErrorKind::usage, "md, html, tex, csv, json", [] { write_report("nowhere", {"pdf"}); });
}

}  // namespace
}  // namespace facet
