#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

#include "record/csv.hpp"
#include "record/run_record.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

FrameRow example_row() {
  FrameRow row;
  row.dataset = "osd";
  row.frame = "a \"quoted\", name\nwith a break";
  row.method = "default";
  row.status = FrameStatus::method_error;
  row.reason = "größer";
  row.surfaces = 7;
  row.missing_px = 5'000'000'000;
  row.rejected = {{"too_small", 3}};
  row.pictures = {"overlays/x.png"};
  return row;
}

TEST(FrameRow, ReadsBackFromItsLine) {
  const std::string line = to_json_line(example_row());
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  const FrameRow read = frame_row_from_json(line);
  EXPECT_EQ(to_json_line(read), line);
  EXPECT_EQ(read.frame, example_row().frame);
  EXPECT_EQ(read.status, FrameStatus::method_error);
  EXPECT_EQ(read.missing_px, 5'000'000'000);
}

TEST(FrameRow, ALineThatWasCutOffIsLeftOutAndABrokenOneIsAnError) {
  const std::string line = to_json_line(example_row());
  EXPECT_EQ(frame_rows_from_jsonl(line + line + line.substr(0, 20)).size(), 2u);
  expect_error(ErrorKind::data, "not a frame row", [&] { frame_rows_from_jsonl(line.substr(0, 20) + "\n"); });
}

TEST(FrameRow, AFailedFrameHasNoCountsInTheTable) {
  FrameRow ok = example_row();
  ok.status = FrameStatus::ok;
  const auto rows = parse_csv(frames_csv({example_row(), ok}));
  ASSERT_EQ(rows.size(), 3u);
  const auto surfaces = std::find(rows[0].begin(), rows[0].end(), "surfaces") - rows[0].begin();
  EXPECT_EQ(rows[1][static_cast<std::size_t>(surfaces)], "");
  EXPECT_EQ(rows[2][static_cast<std::size_t>(surfaces)], "7");
}

TEST(Csv, AwkwardFieldsReadBack) {
  const CsvRow row{"", "a,b", "\"", "two\nlines", "plain"};
  const auto read = parse_csv(csv_line(row) + csv_line(row));
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[1], row);
}

TEST(Csv, ANumberThatIsNotFiniteIsEmpty) {
  EXPECT_EQ(csv_number(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(csv_number(std::numeric_limits<double>::infinity()), "");
  EXPECT_EQ(csv_number(0.1), "0.1");
}

TEST(TimingRows, ReadBackFromTheirTable) {
  TimingTable table;
  table.stages = {"fill", "pose"};
  TimingSample sample{"osd", "learn6", "default"};
  sample.phase = TimingPhase::warmup;
  sample.repeat = 2;
  sample.surfaces = 9;
  sample.posed = 8;
  sample.total_ms = 12.5;
  sample.stage_ms = {1.25, 2};
  table.samples = {sample, sample};
  const TimingTable read = timing_from_csv(to_csv(table));
  EXPECT_EQ(to_csv(read), to_csv(table));
  EXPECT_EQ(read.stages, table.stages);
  EXPECT_EQ(read.samples[1].stage_ms, sample.stage_ms);
  EXPECT_EQ(read.samples[1].phase, TimingPhase::warmup);
}

TEST(TimingRows, ARowThatDoesNotFitItsHeaderIsAnError) {
  TimingTable table;
  table.stages = {"fill"};
  expect_error(ErrorKind::data, "fields", [&] { timing_from_csv(to_csv(table) + "osd,learn6\n"); });
}

TEST(Manifest, ReadsBackAndRejectsAnotherSchema) {
  Manifest manifest;
  manifest.status = RunStatus::partial;
  manifest.command = {"facet", "run"};
  manifest.notes = {"not scored"};
  const std::string text = to_json(manifest);
  EXPECT_EQ(to_json(manifest_from_json(text)), text);
  std::string other = text;
  other.replace(other.find("\"schema_version\": 1"), 19, "\"schema_version\": 9");
  expect_error(ErrorKind::data, "schema_version 9", [&] { manifest_from_json(other); });
}

TEST(RunRecord, AFolderWithoutAManifestIsNoRun) {
  TemporaryFolder folder;
  expect_error(ErrorKind::data, "not a run directory", [&] { read_run(folder.path()); });
}

}  // namespace
}  // namespace facet
