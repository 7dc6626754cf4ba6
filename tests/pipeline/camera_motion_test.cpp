#include "pipeline/camera_motion.hpp"

#include <gtest/gtest.h>
#include <numbers>

#include "pipeline/static_sequence.hpp"
#include "stage/temporal_average.hpp"

namespace facet {
namespace {

constexpr double threshold = double{TemporalParams{}.max_motion_sigmas};
constexpr double step_m = 0.05 / 30;  // 5 cm/s at 30 frames per second

std::vector<View> two_views() {
  std::vector<View> views = quickstart_views(5);
  return {views[1], views[4]};
}

/// Change that is measured between two frames, the second taken from a place moved by `motion`.
double change_between(const SequenceCamera& camera, const RigidMotion& motion, bool with_pose, int seed = 1) {
  const Image<float> first = camera.measured(static_cast<std::uint64_t>(2 * seed)),
                     second = camera.measured(static_cast<std::uint64_t>(2 * seed + 1), motion);
  FrameInput before{first.view(), camera.camera()}, now{second.view(), camera.camera()};
  if (with_pose) {
    before.T_world_camera = camera.pose();
    now.T_world_camera = camera.pose(motion);
  }
  CameraMotion measured;
  measured.start_from(before, camera.noise());
  return measured.change_sigmas(now);
}

class CameraMotionOf : public ::testing::TestWithParam<Sensor> {};

TEST_P(CameraMotionOf, is_not_seen_where_the_camera_stands_still) {
  for (const View& view : two_views())
    for (int seed = 1; seed <= 2; ++seed)
      EXPECT_LT(change_between({view, GetParam()}, {}, false, seed), threshold) << view.name;
}

TEST_P(CameraMotionOf, is_seen_within_one_frame_at_5_cm_per_second) {
  for (const View& view : two_views())
    for (const Vec3d direction :
         {Vec3d{1, 0, 0}, Vec3d{-1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}, Vec3d{0, 0, -1}})
      for (const bool with_pose : {false, true})
        EXPECT_GT(change_between({view, GetParam()}, translation(step_m * direction), with_pose), threshold)
            << view.name << (with_pose ? ", by pose, " : ", by depth, ") << direction.x << ' ' << direction.y
            << ' ' << direction.z;
}

TEST_P(CameraMotionOf, by_depth_is_what_the_poses_say) {
  const SequenceCamera camera(quickstart_views(5)[2], GetParam());
  for (const RigidMotion& motion : {translation({0, 0.002, 0}), translation({0, 0, -0.003}),
                                    rotation({1, 0, 0}, 0.003), rotation({0, 0, 1}, 0.004)}) {
    const double by_pose = change_between(camera, motion, true),
                 by_depth = change_between(camera, motion, false);
    EXPECT_NEAR(by_depth / by_pose, 1, 0.25);
  }
}

TEST_P(CameraMotionOf, another_view_is_motion_however_far) {
  const std::vector<View> views = quickstart_views(5);
  const SequenceCamera a(views[0], GetParam());
  EXPECT_GT(change_between(a, translation({0.1, 0.1, 0.05}), false), threshold);
  EXPECT_GT(change_between(a, rotation({0, 1, 0}, std::numbers::pi), true), 1e9);
  const Image<float> first = a.measured(1), other = SequenceCamera(views[3], GetParam()).measured(2);
  CameraMotion motion;
  motion.start_from({first.view(), a.camera()}, a.noise());
  EXPECT_GT(motion.change_sigmas({other.view(), a.camera()}), threshold);
}

TEST_P(CameraMotionOf, is_not_what_moves_in_a_still_picture) {
  const SequenceCamera camera(quickstart_views(5)[1], GetParam());
  const Image<float> first = camera.measured(1);
  Image<float> second = camera.measured(2);
  for (int y = 200; y < 300; ++y)  // a hand, 3 % of the image
    for (int x = 100; x < 200; ++x) second(x, y) = 0.6f;
  CameraMotion motion;
  motion.start_from({first.view(), camera.camera()}, camera.noise());
  EXPECT_LT(motion.change_sigmas({second.view(), camera.camera()}), threshold);
}

INSTANTIATE_TEST_SUITE_P(Sensors, CameraMotionOf, ::testing::Values(Sensor::kinect_v1, Sensor::azure_kinect),
                         [](const auto& test) {
                           return std::string(sensor_names[static_cast<std::size_t>(test.param)]);
                         });

TEST(CameraMotion, takes_frames_of_any_size_and_without_depth) {
  for (const Size size : {Size{1, 1}, Size{31, 7}, Size{33, 9}, Size{631, 479}})
    for (const float depth_m : {0.0f, 1.0f}) {
      const Image<float> frame(size, depth_m);
      const Camera camera{500, 500, 0, 0};
      CameraMotion motion;
      motion.start_from({frame.view(), camera}, kinect_v1_noise());
      EXPECT_EQ(motion.change_sigmas({frame.view(), camera}), 0);
    }
}

}  // namespace
}  // namespace facet
