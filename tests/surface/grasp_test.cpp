#include "surface/grasp.hpp"

#include <gtest/gtest.h>

#include "surface/grasp_scene.hpp"

namespace facet {
namespace {

GraspParams jaw(float max_opening_mm) {
  GraspParams params;
  params.max_opening_mm = max_opening_mm;
  return params;
}

TEST(FindGrasps, ARectangleIsTakenAcrossItsShortSideFirstThroughTheMiddle) {
  for (const Plane& plane : {facing_plane(), tilted_plane()})
    for (const double turn_deg : {0.0, 25.0, 50.0}) {
      GraspScene scene(plane, rectangle(0.09, 0.05, turn_deg));
      const auto& grasps = scene.grasps();
      ASSERT_EQ(grasps.size(), 2u) << turn_deg;
      EXPECT_NEAR(grasps[0].width_m, 0.05, 0.002);
      EXPECT_NEAR(grasps[1].width_m, 0.09, 0.002);
      EXPECT_GT(grasps[0].score, grasps[1].score);
      EXPECT_NEAR(grasps[0].score, 0.09, 0.005) << "the length of the sides";
      for (const Grasp& grasp : grasps) {
        const Vec3 middle = 0.5f * (grasp.contacts_m[0] + grasp.contacts_m[1]);
        EXPECT_LT(norm(middle - scene.face().pose->centre_m), 0.003f);
      }
    }
}

TEST(FindGrasps, ContactsLieOnThePlaneAndAgreeWithTheImageAndTheAxis) {
  GraspScene scene(tilted_plane(), rectangle(0.08, 0.05, 30));
  ASSERT_FALSE(scene.grasps().empty());
  for (const Grasp& grasp : scene.face().grasps) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec3 p = grasp.contacts_m[i];
      EXPECT_NEAR(scene.face().plane->signed_distance_m(p), 0, 1e-5f);
      const Vec2 px = image_of(scene.camera, p);
      EXPECT_NEAR(px.x, grasp.contacts_px[i].x, 1e-3);
      EXPECT_NEAR(px.y, grasp.contacts_px[i].y, 1e-3);
    }
    const Vec3 across = grasp.contacts_m[1] - grasp.contacts_m[0];
    EXPECT_NEAR(norm(across), grasp.width_m, 1e-5f);
    EXPECT_NEAR(dot(normalized(across), grasp.closing_axis), 1, 1e-5f);
    EXPECT_NEAR(dot(grasp.closing_axis, scene.face().plane->normal), 0, 1e-4f);
  }
}

TEST(FindGrasps, OnlyWidthsThatTheJawSpansAreTaken) {
  GraspScene scene(facing_plane(), rectangle(0.09, 0.05));
  EXPECT_EQ(scene.grasps(jaw(85)).size(), 1u);
  EXPECT_NEAR(scene.face().grasps[0].width_m, 0.05, 0.002);
  EXPECT_TRUE(scene.grasps(jaw(45)).empty());
  GraspParams wide;
  wide.min_opening_mm = 60;
  ASSERT_EQ(scene.grasps(wide).size(), 1u);
  EXPECT_NEAR(scene.face().grasps[0].width_m, 0.09, 0.002);
}

TEST(FindGrasps, ADiscIsTakenAcrossItsMiddle) {
  for (const double diameter_m : {0.03, 0.05, 0.09}) {
    GraspScene scene(tilted_plane(), disc(diameter_m));
    const auto& grasps = scene.grasps();
    ASSERT_GE(grasps.size(), 2u) << diameter_m;
    for (const Grasp& grasp : grasps) {
      EXPECT_NEAR(grasp.width_m, diameter_m, 0.006);
      EXPECT_LT(norm(0.5f * (grasp.contacts_m[0] + grasp.contacts_m[1]) - scene.face().pose->centre_m),
                0.006f);
    }
    EXPECT_TRUE(scene.grasps(jaw(static_cast<float>(800 * diameter_m))).empty());
  }
}

TEST(FindGrasps, OffsetSidesAreTakenWhereTheyOverlapByAFinger) {
  const auto offset_bars = [](double offset_m) {  // an S of two halves, its outer sides shifted along
    return [=](Vec2 p) {
      const bool upper = p.y < 0 && p.y > -0.02 && std::fabs(p.x + offset_m / 2) < 0.03;
      return upper || (p.y >= 0 && p.y < 0.02 && std::fabs(p.x - offset_m / 2) < 0.03);
    };
  };
  const auto across_both = [](const std::vector<Grasp>& grasps) {
    return std::any_of(grasps.begin(), grasps.end(), [](const Grasp& g) {
      return std::fabs(g.closing_axis.y) > 0.95f && std::fabs(g.width_m - 0.04f) < 0.003f;
    });
  };
  GraspParams params = jaw(50);
  params.most_per_surface = 10;
  EXPECT_TRUE(across_both(GraspScene(facing_plane(), offset_bars(0.03)).grasps(params)));
  EXPECT_FALSE(across_both(GraspScene(facing_plane(), offset_bars(0.052)).grasps(params)));
}

TEST(FindGrasps, ASlantedPairIsTakenOnlyWithEnoughFriction) {
  const auto wedge = [](Vec2 p) { return std::fabs(p.y) < 0.03 && std::fabs(p.x) < 0.03 - 0.5 * p.y; };
  GraspScene scene(facing_plane(), wedge);  // sides lean by 26.6 degrees, bases are 30 mm and 90 mm long
  const auto across_the_sides = [&](float friction) {
    GraspParams params;
    params.friction = friction;
    const auto& grasps = scene.grasps(params);
    return std::any_of(grasps.begin(), grasps.end(),
                       [](const Grasp& g) { return std::fabs(g.closing_axis.x) > 0.99f; });
  };
  EXPECT_FALSE(across_the_sides(0.4f));
  EXPECT_TRUE(across_the_sides(0.6f));
}

TEST(FindGrasps, ATriangleIsNotTakenByItsSides) {
  const auto triangle = [](Vec2 p) { return p.y < 0.025 && std::sqrt(3.0) * std::fabs(p.x) < p.y + 0.045; };
  EXPECT_TRUE(GraspScene(facing_plane(), triangle).grasps().empty());
}

TEST(FindGrasps, SidesThatTouchSomethingAreNotTaken) {
  GraspScene scene(facing_plane(), rectangle(0.08, 0.05));
  const int bottom = static_cast<int>(119.5 + 0.024 * 525 / 0.8);
  scene.mark_outline(EdgeKind::concave, [&](ContourPoint p) { return p.y >= bottom; });
  const auto& grasps = scene.grasps();
  ASSERT_EQ(grasps.size(), 1u);
  EXPECT_GT(std::fabs(grasps[0].closing_axis.x), 0.99f);
}

TEST(FindGrasps, AFingerNeedsRoomOutside) {
  const auto with_block = [](int gap_px, float depth_m) {
    GraspScene scene(facing_plane(), rectangle(0.08, 0.05));
    const int right = static_cast<int>(159.5 + 0.04 * 525 / 0.8) + gap_px;
    for (int y = 60; y < 180; ++y)
      for (int x = right; x < right + 40; ++x) scene.depth_m(x, y) = depth_m;
    return scene.grasps().size();
  };
  EXPECT_EQ(with_block(5, 0.7f), 1u) << "a taller neighbour 8 mm away";
  EXPECT_EQ(with_block(14, 0.7f), 2u) << "a taller neighbour 21 mm away";
  EXPECT_EQ(with_block(5, 0.85f), 2u) << "a lower neighbour";
}

TEST(FindGrasps, TheFingersAvoidWhatStandsBesideTheMiddle) {
  GraspScene scene(facing_plane(), rectangle(0.12, 0.05));
  const int bottom = static_cast<int>(119.5 + 0.025 * 525 / 0.8) + 4;
  for (int y = bottom; y < bottom + 20; ++y)
    for (int x = 145; x < 170; ++x) scene.depth_m(x, y) = 0.7f;
  const auto& grasps = scene.grasps();
  ASSERT_EQ(grasps.size(), 1u);
  EXPECT_NEAR(grasps[0].width_m, 0.05, 0.002);
  const double off_middle_m = std::fabs(static_cast<double>(grasps[0].contacts_m[0].x));
  EXPECT_GT(off_middle_m, (10 + 5) * 0.8 / 525);
  EXPECT_LT(off_middle_m, 0.055);
}

TEST(FindGrasps, WhatStandsBetweenTheContactsBlocksThem) {
  const auto with_post = [](float depth_m) {
    GraspScene scene(facing_plane(), rectangle(0.08, 0.05));
    for (int y = 108; y < 132; ++y)
      for (int x = 136; x < 184; ++x) scene.depth_m(x, y) = depth_m, scene.labels(x, y) = 2;
    return scene.grasps().size();
  };
  EXPECT_EQ(with_post(0.7f), 0u);
  EXPECT_EQ(with_post(0.9f), 2u) << "through a hole";
}

TEST(FindGrasps, ACylinderIsTakenByItsSilhouettes) {
  // A standing cylinder of 6 cm diameter whose axis is 0.8 m away and leans away from the camera.
  constexpr double radius = 0.03, axis_z = 0.8;
  const Vec3 axis = normalized({0, 1, -0.5f});
  GraspScene scene(facing_plane(), rectangle(0.01, 0.01));
  scene.edges = Image<std::uint8_t>(GraspScene::size, 0);
  for (int y = 60; y < 180; ++y)
    for (int x = 0; x < 320; ++x) {
      const Vec3 ray = scene.camera.back_project(static_cast<float>(x), static_cast<float>(y), 1);
      const Vec3 across = ray - dot(ray, axis) * axis;
      const Vec3 centre{0, 0, static_cast<float>(axis_z)};
      const Vec3 to_axis = centre - dot(centre, axis) * axis;
      const double a = dot(across, across), b = dot(across, to_axis),
                   c = dot(to_axis, to_axis) - radius * radius;
      if (b * b < a * c) continue;
      scene.labels(x, y) = 1;
      scene.depth_m(x, y) = static_cast<float>((b - std::sqrt(b * b - a * c)) / a);
    }
  scene.surfaces = numbered_surfaces(1);
  trace_regions(scene.labels.view(), boxes_of(scene.labels), scene.surfaces);
  scene.mark_outline(EdgeKind::depth, [](ContourPoint) { return true; });
  scene.mark_outline(EdgeKind::concave, [](ContourPoint p) { return p.y == 60 || p.y == 179; });
  scene.face().plane = facing_plane(0.77f);
  scene.face().pose = pose_on_plane(*scene.face().plane, {0, 0, 0.77f});
  scene.face().curved = true;
  const auto& grasps = scene.grasps();
  ASSERT_FALSE(grasps.empty());
  EXPECT_NEAR(grasps[0].width_m, 2 * radius, 0.003);
  EXPECT_GT(std::fabs(grasps[0].closing_axis.x), 0.99f);
  for (const Vec3& contact : grasps[0].contacts_m) {
    const Vec3 from_axis = contact - Vec3{0, 0, static_cast<float>(axis_z)};
    EXPECT_NEAR(norm(from_axis - dot(from_axis, axis) * axis), radius, 0.004) << "on the cylinder";
  }
}

TEST(FindGrasps, SurfacesWithoutAPoseOrAnOutlineHaveNone) {
  GraspScene scene(facing_plane(), rectangle(0.08, 0.05));
  const auto pose = scene.face().pose;
  scene.face().pose.reset();
  EXPECT_TRUE(scene.grasps().empty());
  scene.face().pose = pose;
  EXPECT_FALSE(scene.grasps().empty());
  scene.face().contour.outer.clear();
  EXPECT_TRUE(scene.grasps().empty());
}

TEST(FindGrasps, TheBestOnesAreKeptAndTheSameEveryTime) {
  GraspScene scene(tilted_plane(), disc(0.09));
  GraspParams params;
  params.most_per_surface = 100;
  const std::vector<Grasp> all = scene.grasps(params);
  ASSERT_GT(all.size(), 3u);
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LE(all[i].score, all[i - 1].score);
  const std::vector<Grasp> best = scene.grasps();
  ASSERT_EQ(best.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(best[i].contacts_m, all[i].contacts_m);
}

}  // namespace
}  // namespace facet
