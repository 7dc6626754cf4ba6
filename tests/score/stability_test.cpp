#include "score/stability.hpp"

#include <gtest/gtest.h>

namespace facet {
namespace {

constexpr Size size{64, 48};
constexpr Camera camera{60, 60, 31.5f, 23.5f};

/// A wall at 1 m, a rectangle of it for every label, with its pose.
struct Picture {
  Image<float> depth_m{size, 1.0f};
  Prediction prediction;

  Picture() { prediction.labels.resize(size); }
  Picture& add(int label, int x0, int y0, int width, int height) {
    for (int y = y0; y < y0 + height; ++y)
      for (int x = x0; x < x0 + width; ++x) prediction.labels(x, y) = static_cast<std::uint16_t>(label);
    Surface surface;
    surface.id = label;
    surface.plane = Plane{{0, 0, -1}, 1};
    surface.pose = SurfacePose{};
    surface.pose->centre_m =
        camera.back_project(static_cast<float>(x0) + static_cast<float>(width - 1) / 2,
                            static_cast<float>(y0) + static_cast<float>(height - 1) / 2, 1);
    prediction.surfaces.push_back(surface);
    return *this;
  }
  StabilityInput input(std::optional<RigidMotion> pose = {}) const {
    return {depth_m.view(), camera, pose, prediction};
  }
};

TEST(Stability, the_first_frame_is_not_compared) {
  StabilityTracker tracker;
  const FrameStability row = tracker.next(Picture().add(1, 0, 0, 20, 20).input());
  EXPECT_FALSE(row.compared);
  EXPECT_EQ(row.regions, 0);
  ASSERT_EQ(row.planes.size(), 1u);
}

TEST(Stability, the_same_regions_under_other_labels_agree_wholly) {
  StabilityTracker tracker;
  const auto first = tracker.next(Picture().add(1, 0, 0, 20, 20).add(2, 30, 10, 20, 20).input());
  const auto second = tracker.next(Picture().add(7, 30, 10, 20, 20).add(9, 0, 0, 20, 20).input());
  EXPECT_EQ(second.iou_sum, 4);
  EXPECT_EQ(second.regions, 4);
  EXPECT_EQ(second.covered_px, second.region_px);
  EXPECT_EQ(second.before, 2);
  EXPECT_EQ(second.kept, 2);
  EXPECT_EQ(second.planes[0].track, first.planes[1].track);
  EXPECT_EQ(second.planes[1].track, first.planes[0].track);
}

TEST(Stability, a_region_that_moves_by_a_quarter_overlaps_by_three_fifths) {
  StabilityTracker tracker;
  tracker.next(Picture().add(1, 0, 0, 20, 20).input());
  const auto row = tracker.next(Picture().add(1, 5, 0, 20, 20).input());
  EXPECT_NEAR(row.iou_sum, 2 * 0.6, 1e-12);
  EXPECT_EQ(row.kept, 1);
}

TEST(Stability, a_region_that_falls_apart_is_lost) {
  StabilityTracker tracker;
  const auto first = tracker.next(Picture().add(1, 0, 0, 40, 20).input());
  const auto row = tracker.next(Picture().add(1, 0, 0, 20, 20).add(2, 20, 0, 20, 20).input());
  EXPECT_EQ(row.before, 1);
  EXPECT_EQ(row.kept, 0);
  EXPECT_EQ(row.iou_sum, 1.5);  // half of it, and both halves half of what was
  EXPECT_NE(row.planes[0].track, first.planes[0].track);
  EXPECT_NE(row.planes[0].track, row.planes[1].track);
}

TEST(Stability, small_regions_do_not_count) {
  StabilityTracker tracker;
  tracker.next(Picture().add(1, 0, 0, 9, 11).input());
  EXPECT_EQ(tracker.next(Picture().add(1, 0, 0, 9, 11).input()).regions, 0);
}

TEST(Stability, a_camera_that_is_known_to_move_changes_nothing) {
  StabilityTracker known, unknown;
  const RigidMotion moved = translation({0.1, 0, 0});  // 6 px
  const Picture before = Picture().add(1, 20, 10, 20, 20), after = Picture().add(1, 14, 10, 20, 20);
  const auto first = known.next(before.input(RigidMotion{}));
  const auto second = known.next(after.input(moved));
  EXPECT_TRUE(second.in_world);
  EXPECT_EQ(second.iou_sum, 2);
  EXPECT_NEAR(norm(second.planes[0].centre_m - first.planes[0].centre_m), 0, 1e-6);
  unknown.next(before.input());
  const auto blind = unknown.next(after.input());
  EXPECT_FALSE(blind.in_world);
  EXPECT_LT(blind.iou_sum, 1.2);
}

TEST(Stability, what_comes_into_view_is_not_lost_and_not_compared) {
  StabilityTracker tracker;
  // A camera 12 px further right no more sees the left region, and sees a new one on the right.
  tracker.next(Picture().add(1, 0, 0, 11, 40).add(2, 30, 0, 20, 20).input(RigidMotion{}));
  const auto row =
      tracker.next(Picture().add(2, 18, 0, 20, 20).add(3, 53, 0, 11, 40).input(translation({0.2, 0, 0})));
  EXPECT_EQ(row.before, 1);
  EXPECT_EQ(row.kept, 1);
  EXPECT_EQ(row.regions, 2);
}

TEST(Stability, nothing_is_compared_across_a_frame_that_failed) {
  StabilityTracker tracker;
  const Picture picture = Picture().add(1, 0, 0, 20, 20);
  tracker.next(picture.input());
  tracker.interrupt();
  EXPECT_FALSE(tracker.next(picture.input()).compared);
  EXPECT_TRUE(tracker.next(picture.input()).compared);
}

TEST(Stability, curved_surfaces_and_those_without_pose_have_no_jitter) {
  Picture picture = Picture().add(1, 0, 0, 20, 20).add(2, 30, 0, 20, 20);
  picture.prediction.surfaces[0].curved = true;
  picture.prediction.surfaces[1].pose.reset();
  EXPECT_TRUE(StabilityTracker().next(picture.input()).planes.empty());
}

}  // namespace
}  // namespace facet
