#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/facet_process.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* experiment =
    "schema: 1\ndatasets: [{name: set, reader: benchmark, root: spec.yaml, cache: cache}]\n"
    "methods: [{name: default}]\ntiming: {warmup: 0, repeats: 2}\n"
    "outputs: {overlays: false, predictions: false, gallery: 1}\n";

/// A small scored and timed run with a gallery of one frame.
class ReportCommand : public ::testing::Test {
 protected:
  ReportCommand() {
    facet.write("spec.yaml", "schema: 1\nname: s\nsets: [{name: set, scenes: boxes, count: 2}]\n");
    facet.write("exp.yaml", experiment);
    run = facet.run({"run", "exp.yaml", "-o", "out", "-q"});
  }
  FacetProcess facet;
  ProcessResult run;
};

TEST_F(ReportCommand, RendersEveryFormatFromStoredRowsAlone) {
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const fs::path folder = facet.latest("out", "exp");
  const std::string page = file_text(folder / "report/report.html");
  EXPECT_THAT(page, HasSubstr("Worst frames"));
  EXPECT_THAT(page, HasSubstr("<svg class=\"chart\""));
  EXPECT_GT(fs::file_size(folder / "metrics/surfaces.csv"), 100u);
  EXPECT_GT(fs::file_size(folder / "metrics/edges.csv"), 100u);
  fs::remove_all(folder / "report");
  fs::remove_all(facet.folder() / "cache");
  const auto report = facet.run({"report", folder.string(), "--format", "md,html,tex,csv,json"});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_EQ(file_text(folder / "report/report.html"), page);
  for (const char* file :
       {"report.md", "report.csv", "report.json", "table2.tex", "table3.tex", "tables.tex"})
    EXPECT_TRUE(fs::exists(folder / "report" / file)) << file;
}

TEST_F(ReportCommand, TheGalleryNamesACommandThatRunsItsFrameAgain) {
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto gallery = facet.run({"gallery", "out/exp/latest", "--worst", "1", "--by", "surface_recall_0.5"});
  EXPECT_EQ(gallery.exit_code, 0) << gallery.err;
  EXPECT_THAT(gallery.out,
              HasSubstr("facet run out/exp/latest/config.resolved.yaml --filter '^set/boxes_00"));
  EXPECT_TRUE(fs::exists(facet.latest("out", "exp") / "report/gallery.html"));
  const auto again = facet.run(
      {"run", "out/exp/latest/config.resolved.yaml", "--filter", "^set/boxes_000$", "-o", "again", "-q"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

TEST_F(ReportCommand, UnknownFormatsScoresAndTargetsAreWrongCommandLines) {
  EXPECT_EQ(facet.run({"report", "out/exp/latest", "--format", "pdf"}).exit_code, 2);
  EXPECT_EQ(facet.run({"gallery", "out/exp/latest", "--by", "beauty"}).exit_code, 2);
  EXPECT_EQ(facet.run({"gallery", "nowhere"}).exit_code, 4);
  EXPECT_EQ(facet.run({"reproduce", "table9"}).exit_code, 2);
}

}  // namespace
}  // namespace facet
