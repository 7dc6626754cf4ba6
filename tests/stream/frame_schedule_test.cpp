#include "stream/frame_schedule.hpp"

#include <array>
#include <gtest/gtest.h>

#include "support/expect_error.hpp"

namespace facet {
namespace {

constexpr std::array<double, 3> stamps_s{10.0, 10.1, 10.4};

TEST(FrameSchedule, AFixedRateIsKeptForEver) {
  StreamOptions options;
  options.rate_hz = 25;
  const FrameSchedule schedule(options, stamps_s);
  EXPECT_TRUE(schedule.is_paced());
  EXPECT_EQ(schedule.due_s(0), 0);
  EXPECT_DOUBLE_EQ(schedule.due_s(100000), 4000);
}

TEST(FrameSchedule, RecordedTimesAreKeptAndTheNextRoundFollowsAfterTheMeanDistance) {
  StreamOptions options;
  options.pace = StreamPace::recorded;
  const FrameSchedule schedule(options, stamps_s);
  EXPECT_DOUBLE_EQ(schedule.due_s(0), 0);
  EXPECT_NEAR(schedule.due_s(1), 0.1, 1e-9);
  EXPECT_NEAR(schedule.due_s(2), 0.4, 1e-9);
  EXPECT_NEAR(schedule.due_s(3), 0.6, 1e-9);
  EXPECT_NEAR(schedule.due_s(7), 1.3, 1e-9);
}

TEST(FrameSchedule, AsFastAsPossibleEverythingIsDueAtOnce) {
  StreamOptions options;
  options.pace = StreamPace::fastest;
  const FrameSchedule schedule(options, stamps_s);
  EXPECT_FALSE(schedule.is_paced());
  EXPECT_EQ(schedule.due_s(1000), 0);
}

TEST(FrameSchedule, TimesThatDoNotAscendAreNoRate) {
  StreamOptions options;
  options.pace = StreamPace::recorded;
  expect_error(ErrorKind::data, "frame 1 has time 1.000000 s, the frame before has 1.000000 s", [&] {
    FrameSchedule(options, std::array{1.0, 1.0});
  });
  expect_error(ErrorKind::data, "one frame has no rate", [&] { FrameSchedule(options, std::array{1.0}); });
}

TEST(FrameSchedule, WithoutANumberOrATimeEveryFrameIsOfferedOnce) {
  StreamOptions options;
  EXPECT_EQ(frame_limit(options, 7), 7u);
  options.seconds = 1;
  EXPECT_EQ(frame_limit(options, 7), 0u);
  options.frames = 3;
  EXPECT_EQ(frame_limit(options, 7), 3u);
}

}  // namespace
}  // namespace facet
