#include "record/sequence_summary.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace facet {
namespace {

FrameRow row_at(int i) {
  FrameRow row;
  row.dataset = std::string("d");
  row.frame = std::to_string(i);
  row.method = std::string("m");
  row.is_sequence = true;
  row.sequence.emplace();
  row.sequence->timestamp_s = i / 10.0;
  return row;
}

TEST(SequenceRow, comes_back_from_json_as_it_was) {
  FrameRow row = row_at(3);
  row.sequence->camera_posed = true;
  row.sequence->window = {5, WindowStart::motion, 0.0667};
  row.sequence->stability = {true, true, 1.5, 3, 100.5, 200, 4, 2, {{7, {0, 0, -1}, {0.1, 0.2, 0.3}}}};
  const FrameRow read = frame_row_from_json(to_json_line(row));
  ASSERT_TRUE(read.sequence);
  EXPECT_EQ(read.sequence->timestamp_s, 0.3);
  EXPECT_EQ(read.sequence->window.start, WindowStart::motion);
  EXPECT_EQ(read.sequence->window.mean_age_s, 0.0667);
  EXPECT_EQ(read.sequence->stability.covered_px, 100.5);
  ASSERT_EQ(read.sequence->stability.planes.size(), 1u);
  EXPECT_EQ(read.sequence->stability.planes[0].centre_m, (Vec3d{0.1, 0.2, 0.3}));
  EXPECT_EQ(to_json_line(read), to_json_line(row));
}

TEST(SequenceRow, may_be_absent_as_in_rows_of_earlier_versions) {
  std::string line = to_json_line(FrameRow{});
  const std::string key = ",\"sequence\":null";
  ASSERT_NE(line.find(key), std::string::npos);
  line.erase(line.find(key), key.size());
  EXPECT_FALSE(frame_row_from_json(line).sequence);
}

TEST(SequenceSummary, counts_windows_and_the_age_of_their_readings) {
  std::vector<FrameRow> rows{row_at(0), row_at(1), row_at(2), row_at(3)};
  rows[0].sequence->window = {1, WindowStart::first, 0.0};
  rows[1].sequence->window = {2, WindowStart::continued, 0.05};
  rows[2].sequence->window = {3, WindowStart::continued, 0.1};
  rows[3].sequence->window = {1, WindowStart::gap, 0.0};
  rows[1].truth_source = "a";
  const auto summaries = summarize_sequences(rows);
  ASSERT_EQ(summaries.size(), 1u);
  const SequenceSummary& s = summaries[0];
  EXPECT_EQ(s.frames, 4u);
  EXPECT_EQ(s.with_truth, 1u);
  EXPECT_EQ(s.window_frames, 7.0 / 4);
  EXPECT_NEAR(*s.mean_age_s, 0.0375, 1e-12);
  EXPECT_EQ(s.most_age_s, 0.1);
  EXPECT_EQ(s.starts, (std::map<std::string, std::size_t>{{"first", 1}, {"gap", 1}}));
  EXPECT_NEAR(*s.period_s, 0.1, 1e-12);
  EXPECT_NEAR(*s.duration_s, 0.3, 1e-12);
  EXPECT_FALSE(s.region_iou);
  EXPECT_FALSE(s.life_s);
}

TEST(SequenceSummary, a_region_lives_as_long_as_it_is_seen_per_loss) {
  std::vector<FrameRow> rows{row_at(0), row_at(1), row_at(2)};
  for (const std::size_t i : {1u, 2u}) rows[i].sequence->stability = {true, false, 6.0, 8, 90, 100, 4, 3, {}};
  const SequenceSummary s = summarize_sequences(rows).front();
  EXPECT_EQ(s.compared, 2u);
  EXPECT_EQ(s.in_world, 0u);
  EXPECT_NEAR(*s.region_iou, 0.75, 1e-12);
  EXPECT_NEAR(*s.covering, 0.9, 1e-12);
  EXPECT_NEAR(*s.life_s, 0.1 * 8 / 2, 1e-12);
}

TEST(SequenceSummary, jitter_is_the_deviation_from_the_mean_of_a_plane_that_lasts) {
  std::vector<FrameRow> rows;
  for (int i = 0; i < 6; ++i) {
    const double side = i % 2 == 0 ? 1 : -1, tilt = side * std::numbers::pi / 180;
    rows.push_back(row_at(i));
    rows.back().sequence->stability.planes = {
        {1, {std::sin(tilt), 0, -std::cos(tilt)}, {0, 0.002 * side, 1}}};
    if (i < 4) rows.back().sequence->stability.planes.push_back({2, {0, 0, -1}, {0, 0, 2.0 * i}});
  }
  const SequenceSummary s = summarize_sequences(rows).front();
  EXPECT_EQ(s.normal_jitter_deg.n, 6u) << "the second plane is seen too seldom";
  EXPECT_NEAR(*s.normal_jitter_deg.p50, 1, 1e-9);
  EXPECT_NEAR(*s.centre_jitter_mm.p95, 2, 1e-9);
}

TEST(SequenceSummary, frames_of_no_sequence_have_none) {
  EXPECT_TRUE(summarize_sequences({FrameRow{}}).empty());
}

}  // namespace
}  // namespace facet
