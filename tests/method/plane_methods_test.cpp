#include <cmath>
#include <gtest/gtest.h>

#include "method/registry.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

constexpr Camera camera{300, 300, 159.5f, 119.5f};

/// A wall that faces the camera on the left, and one that turns away by 45 degrees on the right.
Frame two_walls() {
  Frame frame;
  frame.id = "walls";
  frame.camera = camera;
  frame.depth_m = Image<float>(Size{320, 240}, 1.0f);
  for (int y = 0; y < 240; ++y)
    for (int x = 160; x < 320; ++x) {
      const float ray = (static_cast<float>(x) - camera.cx) / camera.fx;
      frame.depth_m(x, y) = 1 / (1 - ray);  // z = 1 + X
    }
  return frame;
}

class PlaneMethod : public ::testing::TestWithParam<const char*> {
 protected:
  MethodSpec spec() const {
    MethodSpec spec;
    spec.name = spec.kind = GetParam();
    return spec;
  }
  bool is_absent() const { return !find_method_kind(spec()).absent.empty(); }
  Prediction process(const Frame& frame) const {
    Prediction prediction;
    StageTimes times;
    make_method(spec(), {})->process(frame, prediction, times);
    EXPECT_GT(times.total_ms, 0);
    return prediction;
  }
};

TEST_P(PlaneMethod, TwoWallsAreTwoSurfacesWithTheirPoses) {
  if (is_absent()) GTEST_SKIP() << find_method_kind(spec()).absent;
  const Prediction found = process(two_walls());
  ASSERT_EQ(found.surfaces.size(), 2u);
  const int left = found.labels(80, 120), right = found.labels(240, 120);
  ASSERT_GT(left, 0);
  ASSERT_GT(right, 0);
  ASSERT_NE(left, right);
  const Surface &facing = found.surfaces[static_cast<std::size_t>(left - 1)],
                &turned = found.surfaces[static_cast<std::size_t>(right - 1)];
  EXPECT_EQ(facing.id, left);
  EXPECT_LT(facing.plane->normal.z, -0.999f);
  EXPECT_NEAR(facing.plane->d_m, 1, 0.005);
  EXPECT_NEAR(turned.plane->normal.x, std::sqrt(0.5), 0.02);
  EXPECT_NEAR(turned.plane->normal.z, -std::sqrt(0.5), 0.02);
  EXPECT_NEAR(facing.pose->centre_m.z, 1, 0.005);
  EXPECT_GT(facing.area_px, 30000);
  EXPECT_FALSE(facing.contour.outer.empty());
  EXPECT_GT(facing.inlier_share, 0.98f);
}

TEST_P(PlaneMethod, WithoutDepthThereIsNothingAndItSaysSo) {
  if (is_absent()) GTEST_SKIP() << find_method_kind(spec()).absent;
  Frame frame = two_walls();
  frame.depth_m.fill(0);
  const Prediction found = process(frame);
  EXPECT_TRUE(found.surfaces.empty());
  EXPECT_EQ(found.note, "no plane was found");
}

TEST_P(PlaneMethod, TheSameFrameGivesTheSameAgain) {
  if (is_absent()) GTEST_SKIP() << find_method_kind(spec()).absent;
  const auto method = make_method(spec(), {});
  Prediction first, again;
  StageTimes times;
  const Frame frame = two_walls();
  method->process(frame, first, times);
  method->process(frame, again, times);
  ASSERT_EQ(first.surfaces.size(), again.surfaces.size());
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x) ASSERT_EQ(first.labels(x, y), again.labels(x, y));
}

TEST_P(PlaneMethod, WhatABuildLacksIsSaidWithTheWayToGetIt) {
  if (!is_absent()) GTEST_SKIP() << "this build has it";
  expect_error(ErrorKind::not_measured, "install", [&] { make_method(spec(), {}); });
}

INSTANTIATE_TEST_SUITE_P(All, PlaneMethod, ::testing::Values("opencv_rgbd", "pcl_planes"));

TEST(PclPlanes, TheStepBesideAWallIsADepthEdge) {
  MethodSpec spec;
  spec.kind = "pcl_planes";
  if (!find_method_kind(spec).absent.empty()) GTEST_SKIP() << find_method_kind(spec).absent;
  Frame frame = two_walls();
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 160; ++x) frame.depth_m(x, y) = 0.8f;
  Prediction found;
  StageTimes times;
  make_method(spec, {})->process(frame, found, times);
  int on_the_step = 0;
  for (int y = 20; y < 220; ++y)
    for (int x = 157; x < 163; ++x) on_the_step += found.edges(x, y) == edge_code(EdgeKind::depth, true);
  EXPECT_GE(on_the_step, 195);
  EXPECT_LE(on_the_step, 205);
}

}  // namespace
}  // namespace facet
