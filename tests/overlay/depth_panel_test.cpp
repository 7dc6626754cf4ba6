#include "overlay/depth_panel.hpp"

#include <gtest/gtest.h>

#include "overlay/example_frame.hpp"

namespace facet {
namespace {

int brightness(const cv::Vec3b& bgr) {
  return bgr[0] + bgr[1] + bgr[2];
}

TEST(DepthPanel, range_leaves_out_one_percent_at_either_end_and_missing_depth) {
  Image<float> depth_m(Size{1001, 1}, 0.0f);
  for (int x = 0; x < 1000; ++x) depth_m(x, 0) = 1.0f + 0.001f * static_cast<float>(x);
  const DepthRange range = displayed_range(depth_m);
  EXPECT_NEAR(range.nearest_m, 1.01f, 0.002f);
  EXPECT_NEAR(range.farthest_m, 1.99f, 0.002f);
  EXPECT_EQ(displayed_range(Image<float>(Size{3, 3}, 0.0f)).farthest_m, 0);
}

TEST(DepthPanel, positions_are_in_steps_of_inverse_depth_and_clamped) {
  const DepthRange range{1, 2};
  EXPECT_DOUBLE_EQ(range.position(1), 0);
  EXPECT_DOUBLE_EQ(range.position(2), 1);
  EXPECT_NEAR(range.position(4.0f / 3), 0.5, 1e-6);
  EXPECT_DOUBLE_EQ(range.position(0.5f), 0);
  EXPECT_DOUBLE_EQ(range.position(9), 1);
  EXPECT_DOUBLE_EQ((DepthRange{1, 1}).position(1), 0);
}

TEST(DepthPanel, near_is_light_far_is_dark_and_missing_is_black) {
  Frame frame = example_frame({64, 48});
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 20; ++x) frame.depth_m(x, y) = 0;
    for (int x = 40; x < 64; ++x) frame.depth_m(x, y) = 3;
  }
  const cv::Mat panel = draw_depth(frame);
  EXPECT_EQ(panel.at<cv::Vec3b>(100, 100), cv::Vec3b(0, 0, 0));
  EXPECT_GT(brightness(panel.at<cv::Vec3b>(100, 300)), brightness(panel.at<cv::Vec3b>(100, 500)) + 100);
}

TEST(DepthPanel, scale_runs_from_the_near_to_the_far_colour) {
  const cv::Mat scale = draw_depth_scale({150, 14});
  EXPECT_GT(brightness(scale.at<cv::Vec3b>(7, 0)), brightness(scale.at<cv::Vec3b>(7, 149)) + 100);
  EXPECT_EQ(draw_depth_scale({1, 1}).cols, 1);
}

}  // namespace
}  // namespace facet
