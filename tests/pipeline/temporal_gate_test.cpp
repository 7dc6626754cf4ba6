#include "pipeline/temporal_gate.hpp"

#include <gtest/gtest.h>

#include "pipeline/static_sequence.hpp"

namespace facet {
namespace {

class Gate : public ::testing::Test {
 protected:
  WindowUse admit(std::optional<double> timestamp_s, Size size = {64, 48},
                  std::optional<RigidMotion> pose = {}) {
    frame_ = Image<float>(size, 1.0f);
    gate_.admit({frame_.view(), {60, 60, 31.5f, 23.5f}, timestamp_s, pose}, params_, kinect_v1_noise());
    return gate_.use();
  }

  TemporalParams params_;
  TemporalGate gate_;
  Image<float> frame_;
};

TEST_F(Gate, lets_in_as_many_frames_as_the_window_holds) {
  for (const int expected : {1, 2, 3, 4, 5, 5, 5}) EXPECT_EQ(admit({}).frames, expected);
  EXPECT_EQ(gate_.use().start, WindowStart::continued);
  gate_.clear();
  EXPECT_EQ(admit({}).start, WindowStart::first);
  EXPECT_EQ(gate_.use().frames, 1);
}

TEST_F(Gate, tells_how_old_the_readings_are_on_average) {
  for (int i = 0; i < 4; ++i) admit(i / 30.0);
  EXPECT_NEAR(*admit(4 / 30.0).mean_age_s, 2 / 30.0, 1e-12);  // (N - 1) / 2 periods
  EXPECT_NEAR(*admit(5 / 30.0).mean_age_s, 2 / 30.0, 1e-12);
  EXPECT_FALSE(admit({}).mean_age_s);
}

TEST_F(Gate, ends_a_window_with_a_gap_in_time) {
  admit(1.0);
  EXPECT_EQ(admit(1.15).start, WindowStart::continued);
  EXPECT_EQ(admit(1.4).start, WindowStart::gap);
  EXPECT_EQ(gate_.use().frames, 1);
  EXPECT_EQ(gate_.use().mean_age_s, 0);
  EXPECT_EQ(admit(1.3).start, WindowStart::gap) << "time ran backwards";
  params_.max_gap_s = 0;
  EXPECT_EQ(admit(9.0).start, WindowStart::continued);
}

TEST_F(Gate, ends_a_window_with_a_frame_of_another_size) {
  admit({});
  EXPECT_EQ(admit({}, {32, 24}).start, WindowStart::size);
}

TEST_F(Gate, ends_a_window_when_the_camera_is_known_to_move) {
  admit({}, {64, 48}, RigidMotion{});
  EXPECT_EQ(admit({}, {64, 48}, RigidMotion{}).start, WindowStart::continued);
  EXPECT_EQ(admit({}, {64, 48}, translation({0, 0, 0.002})).start, WindowStart::motion);
  EXPECT_EQ(admit({}, {64, 48}, translation({0, 0, 0.002})).start, WindowStart::continued);
  params_.max_motion_sigmas = 0;
  EXPECT_EQ(admit({}, {64, 48}, translation({0, 0, 0.5})).start, WindowStart::continued);
}

TEST_F(Gate, slow_motion_adds_up_within_a_window) {
  int longest = 0;
  for (int i = 0; i < 30; ++i) {
    const double z_m = 0.00005 * i;  // 1.5 mm/s: too little from frame to frame
    longest = std::max(longest, admit({}, {64, 48}, translation({0, 0, z_m})).frames);
  }
  EXPECT_GT(longest, 1);
  EXPECT_LE(longest, 5);
  int ended = 0;
  for (int i = 0; i < 30; ++i)
    ended += admit({}, {64, 48}, translation({0, 0, 0.0015 + 0.0002 * i})).start == WindowStart::motion;
  EXPECT_GE(ended, 9);  // 0.2 mm per frame: at least every third frame
}

TEST_F(Gate, a_window_of_one_frame_never_looks_for_motion) {
  params_.frames = 1;
  admit({}, {64, 48}, RigidMotion{});
  EXPECT_EQ(admit({}, {64, 48}, translation({0, 0, 1})).start, WindowStart::continued);
  EXPECT_EQ(gate_.use().frames, 1);
}

}  // namespace
}  // namespace facet
