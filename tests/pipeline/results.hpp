#pragma once

#include <gtest/gtest.h>

#include "pipeline/result.hpp"

namespace facet {

template <class T>
void expect_equal_images(const Image<T>& a, const Image<T>& b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      ASSERT_EQ(static_cast<int>(a(x, y)), static_cast<int>(b(x, y))) << what << " at " << x << ", " << y;
}

inline void expect_equal_surfaces(const Surface& a, const Surface& b, const std::string& what) {
  EXPECT_EQ(a.id, b.id) << what;
  EXPECT_EQ(a.area_px, b.area_px) << what;
  EXPECT_EQ(a.contour.outer, b.contour.outer) << what;
  EXPECT_EQ(a.contour.holes, b.contour.holes) << what;
  EXPECT_EQ(a.parent, b.parent) << what;
  EXPECT_EQ(a.children, b.children) << what;
  EXPECT_EQ(a.inlier_share, b.inlier_share) << what;
  EXPECT_EQ(a.rms_m, b.rms_m) << what;
  EXPECT_EQ(a.curved, b.curved) << what;
  EXPECT_EQ(a.touches_border, b.touches_border) << what;
  EXPECT_EQ(a.graspable, b.graspable) << what;
  EXPECT_EQ(a.no_pose_reason, b.no_pose_reason) << what;
  ASSERT_EQ(a.plane.has_value(), b.plane.has_value()) << what;
  if (a.plane) {
    EXPECT_EQ(a.plane->normal, b.plane->normal) << what;
    EXPECT_EQ(a.plane->d_m, b.plane->d_m) << what;
  }
  ASSERT_EQ(a.pose.has_value(), b.pose.has_value()) << what;
  if (a.pose) {
    EXPECT_EQ(a.pose->centre_m, b.pose->centre_m) << what;
    EXPECT_EQ(a.pose->quaternion_wxyz, b.pose->quaternion_wxyz) << what;
    EXPECT_EQ(a.pose->zyx_deg, b.pose->zyx_deg) << what;
    EXPECT_EQ(a.pose->rect_axis, b.pose->rect_axis) << what;
  }
  ASSERT_EQ(a.grasps.size(), b.grasps.size()) << what;
  for (std::size_t i = 0; i < a.grasps.size(); ++i) {
    EXPECT_EQ(a.grasps[i].contacts_m, b.grasps[i].contacts_m) << what;
    EXPECT_EQ(a.grasps[i].contacts_px, b.grasps[i].contacts_px) << what;
    EXPECT_EQ(a.grasps[i].score, b.grasps[i].score) << what;
  }
}

/// Everything but the times, to the bit.
inline void expect_equal_results(const FrameResult& a, const FrameResult& b, const std::string& what) {
  expect_equal_images(a.labels, b.labels, what + ": labels");
  expect_equal_images(a.edges, b.edges, what + ": edges");
  EXPECT_EQ(a.note, b.note) << what;
  ASSERT_EQ(a.surfaces.size(), b.surfaces.size()) << what;
  for (std::size_t i = 0; i < a.surfaces.size(); ++i)
    expect_equal_surfaces(a.surfaces[i], b.surfaces[i], what + ": surface " + std::to_string(i + 1));
  ASSERT_EQ(a.rejected.size(), b.rejected.size()) << what;
  for (std::size_t i = 0; i < a.rejected.size(); ++i) {
    EXPECT_EQ(a.rejected[i].seed, b.rejected[i].seed) << what;
    EXPECT_EQ(a.rejected[i].area_px, b.rejected[i].area_px) << what;
    EXPECT_EQ(a.rejected[i].reason, b.rejected[i].reason) << what;
  }
}

}  // namespace facet
