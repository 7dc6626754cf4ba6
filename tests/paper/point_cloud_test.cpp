#include "paper/point_cloud.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace facet {
namespace {

using ::testing::HasSubstr;

/// Two measured pixels, one of them on a surface with a pose.
PoseCloud small_cloud() {
  Frame frame;
  frame.depth_m = Image<float>({3, 1}, 0.0f);
  frame.depth_m(0, 0) = 1;
  frame.depth_m(2, 0) = 2;
  frame.camera = {100, 100, 0, 0};
  Prediction prediction;
  prediction.labels = Image<std::uint16_t>({3, 1}, 0);
  prediction.labels(2, 0) = 1;
  Surface surface;
  surface.id = 1;
  surface.pose = SurfacePose{};
  surface.pose->centre_m = {0, 0, 2};
  prediction.surfaces = {surface};
  return pose_cloud(frame, prediction, 0.5f);
}

TEST(PoseCloud, HoldsTheMeasuredPixelsAndThreeAxesPerPose) {
  const PoseCloud cloud = small_cloud();
  ASSERT_EQ(cloud.points.size(), 2u + 6u);
  EXPECT_EQ(cloud.points[1].p_m, (Vec3{0.04f, 0, 2}));
  ASSERT_EQ(cloud.axes.size(), 3u);
  EXPECT_EQ(cloud.points[static_cast<std::size_t>(cloud.axes[2][1])].p_m, (Vec3{0, 0, 2.5f}));
}

TEST(PoseCloud, ThePlyFileCountsWhatItHolds) {
  const std::string ply = to_ply(small_cloud());
  EXPECT_THAT(ply, HasSubstr("element vertex 8\n"));
  EXPECT_THAT(ply, HasSubstr("element edge 3\n"));
  EXPECT_THAT(ply, HasSubstr("\n0.0400 0.0000 2.0000 "));
  EXPECT_EQ(std::count(ply.begin(), ply.end(), '\n'), 14 + 8 + 3);
}

TEST(PoseCloud, AnEmptyFrameIsDrawnAndWrittenToo) {
  const PoseCloud empty;
  EXPECT_THAT(to_ply(empty), HasSubstr("element vertex 0\n"));
  EXPECT_EQ(draw_cloud(empty, {64, 48}, 20, 10).size(), cv::Size(64, 48));
}

}  // namespace
}  // namespace facet
