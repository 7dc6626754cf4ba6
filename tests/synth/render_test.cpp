#include "synth/render.hpp"

#include <gtest/gtest.h>
#include <set>

#include "core/random.hpp"
#include "synth/quickstart.hpp"

namespace facet {
namespace {

TEST(Render, DepthOfTheTableSatisfiesItsPlaneEquation) {
  const View view = plane_and_box_view();
  const Rendering image =
      render(PosedScene(view.scene, view.T_world_camera), kinect_v1_camera(), kinect_v1_size());
  int table_px = 0;
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) {
      if (image.surface_ids(x, y) != table_surface_id) continue;
      const Vec3d p = image.depth_m(x, y) * ray_direction(kinect_v1_camera(), x, y);
      ASSERT_NEAR(view.T_world_camera.apply(p).z, 0, 1e-6);
      ++table_px;
    }
  }
  EXPECT_GT(table_px, 100000);
}

TEST(Render, ABoxSeenFromAboveShowsItsTopAndTwoSidesAndNothingElse) {
  const View view = plane_and_box_view();
  const Rendering image =
      render(PosedScene(view.scene, view.T_world_camera), kinect_v1_camera(), kinect_v1_size());
  std::set<int> faces;
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) {
      if (image.object_ids(x, y) == 1) faces.insert(image.surface_ids(x, y) - first_face_id(view.scene, 0));
    }
  }
  EXPECT_EQ(faces.size(), 3u);
  EXPECT_TRUE(faces.contains(0));   // top
  EXPECT_FALSE(faces.contains(1));  // bottom
}

TEST(Render, EveryPixelEqualsTheSingleRayThroughIt) {
  for (const View& view : quickstart_views(3)) {
    const PosedScene posed(view.scene, view.T_world_camera);
    const Rendering image = render(posed, kinect_v1_camera(), kinect_v1_size());
    for (std::uint64_t k = 0; k < 2000; ++k) {
      const int x = static_cast<int>(random_below(640, 5, 0, k)),
                y = static_cast<int>(random_below(480, 5, 1, k));
      const auto hit = posed.cast(kinect_v1_camera(), x, y);
      ASSERT_EQ(hit.has_value(), image.depth_m(x, y) > 0);
      if (!hit) continue;
      ASSERT_NEAR(hit->depth_m, image.depth_m(x, y), 1e-6);
      ASSERT_EQ(hit->surface_id, image.surface_ids(x, y));
      ASSERT_EQ(hit->object_id, image.object_ids(x, y));
      ASSERT_NEAR(norm(to_float(hit->normal) - image.normals(x, y)), 0, 1e-5);
    }
  }
}

TEST(Render, NormalsAreUnitVectorsTowardsTheCamera) {
  for (const View& view : quickstart_views(1)) {
    const Rendering image =
        render(PosedScene(view.scene, view.T_world_camera), kinect_v1_camera(), kinect_v1_size());
    for (int y = 0; y < 480; y += 3) {
      for (int x = 0; x < 640; x += 3) {
        if (image.depth_m(x, y) == 0) continue;
        const Vec3 n = image.normals(x, y);
        ASSERT_NEAR(norm(n), 1, 1e-5);
        ASSERT_LE(dot(n, kinect_v1_camera().back_project(static_cast<float>(x), static_cast<float>(y), 1)),
                  1e-5);
      }
    }
  }
}

TEST(Render, WithoutRoomThereIsNothingBesideTheTable) {
  View view = plane_and_box_view();
  view.scene.table_half_width_m = view.scene.table_half_depth_m = 0.15;
  const Rendering image =
      render(PosedScene(view.scene, view.T_world_camera), kinect_v1_camera(), kinect_v1_size());
  EXPECT_EQ(image.depth_m(0, 0), 0);
  EXPECT_EQ(image.surface_ids(0, 0), 0);
  EXPECT_GT(image.depth_m(320, 240), 0);
}

}  // namespace
}  // namespace facet
