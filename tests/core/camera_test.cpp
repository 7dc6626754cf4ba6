#include "core/camera.hpp"

#include <gtest/gtest.h>

namespace facet {
namespace {

constexpr Camera kinect{525, 520, 319.5f, 239.5f};

TEST(Camera, PutsThePrincipalPointOnTheOpticalAxis) {
  EXPECT_EQ(kinect.back_project(319.5f, 239.5f, 2), (Vec3{0, 0, 2}));
}

TEST(Camera, ProjectsABackProjectedPixelOntoItself) {
  for (const float depth_m : {0.3f, 1.0f, 7.5f})
    for (float y = 0; y < 480; y += 37)
      for (float x = 0; x < 640; x += 41) {
        const Vec3 p = kinect.back_project(x, y, depth_m);
        EXPECT_EQ(p.z, depth_m) << "depth is measured along the optical axis";
        EXPECT_NEAR(525 * p.x / p.z + 319.5f, x, 1e-3);
        EXPECT_NEAR(520 * p.y / p.z + 239.5f, y, 1e-3);
      }
}

TEST(Camera, LooksAlongZWithXToTheRightAndYDown) {
  EXPECT_GT(kinect.back_project(600, 239.5f, 1).x, 0);
  EXPECT_GT(kinect.back_project(319.5f, 400, 1).y, 0);
}

}  // namespace
}  // namespace facet
