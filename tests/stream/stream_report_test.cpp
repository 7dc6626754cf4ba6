#include "stream/stream_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stream/stream_summary.hpp"

namespace facet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// 110 frames at 10 Hz; the filters take 10, 20 and 31 ms, the first ten frames a second.
StreamRecord steady_record() {
  StreamRecord record;
  record.dataset = "desk";
  record.method = "default";
  record.options.rate_hz = 10;
  record.options.warmup = 10;
  record.due = record.offered = 110;
  record.frames_in_memory = 5;
  record.queues.resize(4);
  record.memory = {100, 104, 103};
  for (std::size_t i = 0; i < record.offered; ++i) {
    StreamSample sample;
    sample.number = i;
    sample.done_s = 0.1 * static_cast<double>(i) + 0.07;
    sample.filters = {FilterTimes{i < 10 ? 1000.0 : 10.0, 9}, {20, 19}, {31, 30}};
    sample.pass_ms = 62;
    sample.latency_ms = 70;
    record.samples.push_back(sample);
  }
  return record;
}

TEST(StreamSummary, CountsTheFramesAfterWarmUp) {
  const StreamSummary summary = summarize(steady_record());
  ASSERT_EQ(summary.filters.size(), 3u);
  EXPECT_EQ(summary.filters[0].wall.n, 100);
  EXPECT_DOUBLE_EQ(summary.filters[0].wall.max_ms, 10);
  EXPECT_EQ(summary.filters[1].wall.deadline_misses[0], 0);
  EXPECT_EQ(summary.filters[2].wall.deadline_misses[0], 100);
  EXPECT_EQ(summary.filters[2].wall.deadline_misses[1], 0);
  EXPECT_DOUBLE_EQ(*summary.filters[2].cpu_mean_ms, 30);
  EXPECT_DOUBLE_EQ(summary.latency.wall.mean_ms, 70);
  EXPECT_NEAR(summary.throughput_hz, 10, 1e-9);
}

TEST(StreamSummary, ARateIsSustainedWhereEveryFrameFoundRoomInTime) {
  StreamRecord record = steady_record();
  EXPECT_EQ(summarize(record).is_sustained, std::optional(true));
  record.late = 1;
  EXPECT_EQ(summarize(record).is_sustained, std::optional(false));
  record.late = 0;
  record.due = 111;
  EXPECT_EQ(summarize(record).is_sustained, std::optional(false));
  record.due = 110;
  record.queues.front().dropped = 1;
  EXPECT_EQ(summarize(record).is_sustained, std::optional(false));
  record.options.pace = StreamPace::fastest;
  EXPECT_FALSE(summarize(record).is_sustained);
}

TEST(StreamSummary, ProcessorTimeBoundsWhatTheCoresCouldDo) {
  StreamRecord record = steady_record();
  EXPECT_DOUBLE_EQ(summarize(record).cpu_per_frame_ms.value(), 58);
  EXPECT_FALSE(summarize(record).most_hz) << "the number of cores is not known";
  record.load.cores = 2;
  EXPECT_DOUBLE_EQ(summarize(record).most_hz.value(), 2000.0 / 58);
}

TEST(StreamSummary, TheClockOfAThreadSaysNothingWhereOthersWorkForIt) {
  StreamRecord record = steady_record();
  record.threads_in_frame = 2;
  EXPECT_FALSE(summarize(record).filters.front().cpu_mean_ms);
}

TEST(StreamReport, SaysWhetherTheRateWasSustainedAndWhoMissedThePapersLimit) {
  StreamRecord record = steady_record();
  const std::string text = render_console(make_stream_report("desk", {record}));
  EXPECT_THAT(text, HasSubstr("10 frames/s offered, 10.00 frames/s processed: sustained"));
  EXPECT_THAT(text,
              HasSubstr("segmentation within it, poses over it in 100 of 100, pass over it in 100 of 100"));
  EXPECT_THAT(text, HasSubstr("n/a (n = 100 < 662)"));
  record.queues.front().dropped = 4;
  EXPECT_THAT(render_console(make_stream_report("desk", {record})), HasSubstr("NOT sustained"));
}

TEST(StreamReport, WithoutFramesThatCountItSaysSo) {
  StreamRecord record = steady_record();
  record.samples.resize(5);
  const std::string text = render_console(make_stream_report("desk", {record}));
  EXPECT_THAT(text, HasSubstr("No frame was processed after warm-up"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(StreamReport, JsonHoldsNumbersAndReasonsForThoseThatAreMissing) {
  const auto json = nlohmann::json::parse(stream_json({steady_record()})).at(0);
  EXPECT_EQ(json.at("sustained"), true);
  EXPECT_EQ(json.at("end_to_end").at("p50_ms"), 70);
  EXPECT_TRUE(json.at("pass").at("p99_ms").is_null());
  EXPECT_EQ(json.at("pass").at("p99_reason"), "n = 100 < 662");
  EXPECT_EQ(json.at("filters").at(2).at("over_30.0_ms"), 100);
  EXPECT_EQ(json.at("memory_mb").at("end"), 103);
  EXPECT_EQ(json.at("queues").size(), 4u);
}

TEST(StreamReport, CsvHasALineForEveryFrame) {
  const std::string csv = stream_csv({steady_record()});
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 111);
  EXPECT_THAT(csv, HasSubstr("desk,default,12,1.2700,70.0000,62.0000,0,10.0000,9.0000,20.0000,19.0000"));
}

}  // namespace
}  // namespace facet
