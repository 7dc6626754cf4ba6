#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/run_report.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Report example_report() {
  ReportTable table;
  table.caption = "Times";
  table.header = {"stage", "a <b>", "paper"};
  table.rows = {{"Canny", "1.00 ± 0.10", "-"}, {"  of DD", "12.00 ± 3.00", "-"}};
  table.notes = {"a | note"};
  ReportSection section;
  section.title = "Timing";
  section.tables = {table};
  section.pictures = {{"a picture", "overlays/p.png"}};
  return {"Title", {section}};
}

TEST(RenderConsole, ColumnsLineUpAlthoughSomeCharactersTakeTwoBytes) {
  const std::string text = render_console(example_report());
  EXPECT_THAT(text, HasSubstr("stage           a <b>  paper\n"
                              "Canny     1.00 ± 0.10      -\n"
                              "  of DD  12.00 ± 3.00      -\n"));
}

TEST(RenderConsole, LongTablesAreCutAndSayWhereTheRestIs) {
  Report report = example_report();
  ReportTable& table = report.sections[0].tables[0];
  table.rows.assign(100, {"x", "1", "2"});
  table.full_rows_file = "metrics/frames.csv";
  EXPECT_THAT(render_console(report), HasSubstr("... 70 more in metrics/frames.csv"));
}

TEST(RenderMarkdown, CellsCannotBreakTheTable) {
  const std::string text = render_markdown(example_report());
  EXPECT_THAT(text, HasSubstr("| stage | a \\<b\\> | paper |\n| --- | ---: | ---: |"));
  EXPECT_THAT(text, HasSubstr("a \\| note"));
  EXPECT_THAT(text, HasSubstr("](<../overlays/p.png>)"));
}

TEST(RenderHtml, IsOnePageWithItsPicturesInIt) {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "overlays");
  std::ofstream(folder.path() / "overlays/p.png") << "abcd";
  const std::string text = render_html(example_report(), folder.path());
  EXPECT_THAT(text, HasSubstr("data:image/png;base64,YWJjZA=="));
  EXPECT_THAT(text, HasSubstr("a &lt;b&gt;"));
  EXPECT_THAT(text, HasSubstr("color-scheme: light dark"));
  EXPECT_THAT(text, Not(HasSubstr("http")));
  EXPECT_THAT(text, Not(HasSubstr("<script")));
}

TEST(RenderHtml, AMissingPictureIsSaidToBeMissing) {
  TemporaryFolder folder;
  EXPECT_THAT(render_html(example_report(), folder.path()), HasSubstr("a picture: no pictures kept"));
}

RunRecord failed_run() {
  RunRecord run;
  run.manifest.methods = {"m"};
  run.manifest.datasets = {"d"};
  run.manifest.frames_planned = 2;
  run.manifest.frames_ok = 1;
  run.manifest.frames_data_error = 1;
  FrameRow ok, failed;
  ok.dataset = failed.dataset = "d";
  ok.method = failed.method = "m";
  ok.frame = "good";
  ok.reason = "all depth is missing";
  failed.frame = "bad";
  failed.status = FrameStatus::data_error;
  failed.reason = "bad.png: truncated";
  run.frames = {failed, ok};
  return run;
}

TEST(RunReport, FailedFramesAreCountedAndListedWithTheirReason) {
  const std::string text = render_console(make_run_report(failed_run()));
  EXPECT_THAT(text, HasSubstr("1 of 2 frames processed, 1 failed"));
  EXPECT_THAT(text, HasSubstr("d/bad"));
  EXPECT_THAT(text, HasSubstr("bad.png: truncated"));
  EXPECT_THAT(text, HasSubstr("failed"));
}

TEST(RunReport, AFrameWithoutSurfacesSaysWhyAndARunWithoutTimesSaysSo) {
  const std::string text = render_console(make_run_report(failed_run()));
  EXPECT_THAT(text, HasSubstr("good, m: no surface: all depth is missing"));
  EXPECT_THAT(text, HasSubstr("Not timed."));
}

TEST(RunReport, WithoutPicturesItSaysSo) {
  EXPECT_THAT(render_markdown(make_run_report(failed_run())), HasSubstr("no pictures kept"));
}

}  // namespace
}  // namespace facet
