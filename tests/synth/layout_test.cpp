#include "synth/layout.hpp"

#include <gtest/gtest.h>
#include <set>

#include "core/error.hpp"
#include "synth/families.hpp"
#include "synth/hull_overlap.hpp"
#include "synth/resting.hpp"
#include "synth/shapes.hpp"

namespace facet {
namespace {

TEST(HullOverlap, AgreesWithSeparatingIntervalsOfAlignedBoxes) {
  for (std::uint64_t k = 0; k < 300; ++k) {
    const auto u = [&](std::uint64_t s) { return static_cast<double>(random_uniform(9, s, k)); };
    const Vec3d a{0.1 + u(0), 0.1 + u(1), 0.1 + u(2)}, b{0.1 + u(3), 0.1 + u(4), 0.1 + u(5)};
    const Vec3d shift{2 * u(6) - 1, 2 * u(7) - 1, 2 * u(8) - 1};
    SceneObject p = make_box(a), q = make_box(b);
    q.pose.origin = shift;
    const double gap_x = std::abs(shift.x) - (a.x + b.x) / 2, gap_y = std::abs(shift.y) - (a.y + b.y) / 2;
    const double gap_z = std::max(shift.z - a.z, -shift.z - b.z);
    const double outside = std::sqrt(std::pow(std::max(0.0, gap_x), 2) + std::pow(std::max(0.0, gap_y), 2) +
                                     std::pow(std::max(0.0, gap_z), 2));
    if (std::abs(outside - 0.05) < 1e-6) continue;
    EXPECT_EQ(objects_overlap(p, q, 0.05), outside < 0.05) << k;
  }
}

TEST(HullOverlap, OfBallsIsTheDistanceOfTheirCentres) {
  SceneObject a = make_ball(0.1), b = make_ball(0.2);
  b.pose.origin = {0.25, 0.0, -0.1};  // centres on one level, 0.25 apart
  EXPECT_TRUE(objects_overlap(a, b, 0.001));
  b.pose.origin.x = 0.31;
  EXPECT_FALSE(objects_overlap(a, b, 0.005));
  EXPECT_TRUE(objects_overlap(a, b, 0.02));
}

/// The lowest point of the object above the table.
double lowest(const SceneObject& object) {
  double z = 1e9;
  for (const Hull& hull : posed_hulls(object)) {
    for (const Vec3d& p : hull.points) z = std::min(z, p.z - hull.radius_m);
  }
  return z;
}

TEST(Layout, ObjectsRestOnTheTableOrOnOneAnotherAndDoNotInterpenetrate) {
  for (const SceneRecipe& family : scene_families()) {
    for (std::uint64_t k = 0; k < 10; ++k) {
      const Layout layout = random_layout(family, 5, k, kinect_v1_camera(), kinect_v1_size());
      const auto& objects = layout.view.scene.objects;
      for (std::size_t a = 0; a < objects.size(); ++a) {
        EXPECT_GT(lowest(objects[a]), -1e-9) << family.name;
        if (layout.rests_on[a] < 0) {
          EXPECT_NEAR(lowest(objects[a]), 0, 1e-9) << objects[a].shape;
        }
        for (std::size_t b = 0; b < a; ++b) {
          if (layout.rests_on[a] == static_cast<int>(b)) continue;
          EXPECT_FALSE(objects_overlap(objects[a], objects[b], 1e-4)) << family.name << k;
        }
      }
    }
  }
}

TEST(Layout, AStackedObjectStandsOnALevelTopWithItsMiddleOverIt) {
  int stacked = 0;
  for (std::uint64_t k = 0; k < 20; ++k) {
    const Layout layout =
        random_layout(scene_family("stacked_boxes"), 6, k, kinect_v1_camera(), kinect_v1_size());
    const auto& objects = layout.view.scene.objects;
    for (std::size_t a = 0; a < objects.size(); ++a) {
      if (layout.rests_on[a] < 0) continue;
      ++stacked;
      SceneObject lowered = objects[a];
      lowered.pose.origin.z -= 0.001;
      EXPECT_TRUE(objects_overlap(lowered, objects[static_cast<std::size_t>(layout.rests_on[a])], 1e-5));
      const Vec3d middle =
          objects[static_cast<std::size_t>(layout.rests_on[a])].pose.unapply(objects[a].pose.origin);
      SceneObject needle = make_cylinder(1e-3, 1e-3);
      needle.pose.origin = objects[a].pose.origin - Vec3d{0, 0, 0.002};
      EXPECT_TRUE(objects_overlap(needle, objects[static_cast<std::size_t>(layout.rests_on[a])], 1e-5))
          << middle.x;
    }
  }
  EXPECT_GT(stacked, 15);
}

TEST(Layout, ATowerStandsWhateverItsObjectsWeigh) {
  int third_storeys = 0;
  for (const char* name : {"stacked_boxes", "complex", "clutter"}) {
    for (std::uint64_t k = 0; k < 20; ++k) {
      const Layout layout = random_layout(scene_family(name), 7, k, kinect_v1_camera(), kinect_v1_size());
      const auto& objects = layout.view.scene.objects;
      for (std::size_t a = 0; a < objects.size(); ++a) {
        if (std::abs(objects[a].pose.ez.z) < 1 - 1e-9) continue;  // a board that leans, a lying cylinder
        int storeys = 0;
        for (int b = layout.rests_on[a]; b >= 0; b = layout.rests_on[static_cast<std::size_t>(b)]) {
          const SceneObject& support = objects[static_cast<std::size_t>(b)];
          EXPECT_TRUE(stands_over(support, objects[a])) << name << k;
          third_storeys += ++storeys == 2;
        }
      }
    }
  }
  EXPECT_GT(third_storeys, 5);
}

TEST(Layout, AnUpturnedCupDoesNotStandOnATopSmallerThanItsRim) {
  SceneObject cup = make_cup(0.03, 0.045, 0.1, false);
  cup.pose = upside_down(0.1);
  int carried = 0;
  for (std::uint64_t k = 0; k < 50; ++k) {
    Draws draws(1, k);
    SceneObject on_small = cup, on_large = cup;
    EXPECT_FALSE(stand_on(make_box({0.085, 0.2, 0.05}), on_small, draws));
    carried += stand_on(make_box({0.2, 0.2, 0.05}), on_large, draws);
  }
  EXPECT_GT(carried, 25);
}

TEST(Layout, ObjectsOfASceneDifferInColourAndLieBeyondTheNearestReadingOfTheSensors) {
  for (const SceneRecipe& family : scene_families()) {
    const Layout layout = random_layout(family, 8, 0, kinect_v1_camera(), kinect_v1_size());
    const auto& objects = layout.view.scene.objects;
    for (std::size_t a = 0; a < objects.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) EXPECT_FALSE(objects[a].colour == objects[b].colour);
    }
    const PosedScene posed(layout.view.scene, layout.view.T_world_camera);
    const Rendering image = render(posed, kinect_v1_camera(), kinect_v1_size());
    for (int y = 0; y < image.depth_m.height(); ++y) {
      for (int x = 0; x < image.depth_m.width(); ++x) {
        if (image.object_ids(x, y) == 0) continue;
        ASSERT_GE(image.depth_m(x, y), 0.5f) << family.name;
      }
    }
  }
}

TEST(Layout, TheSameSeedGivesTheSameSceneAndAnotherOneAnother) {
  const auto origin = [](std::uint64_t seed) {
    return random_layout(scene_family("mixed"), seed, 0, kinect_v1_camera(), kinect_v1_size())
        .view.scene.objects[0]
        .pose;
  };
  EXPECT_EQ(origin(1).origin, origin(1).origin);
  EXPECT_NE(origin(1).origin, origin(2).origin);
}

TEST(Layout, EveryNumberOfObjectsFromOneToTwentyIsReached) {
  SceneRecipe recipe = scene_family("clutter");
  for (int n = 1; n <= 20; ++n) {
    recipe.fewest = recipe.most = n;
    const Layout layout =
        random_layout(recipe, 3, static_cast<std::uint64_t>(n), kinect_v1_camera(), kinect_v1_size());
    EXPECT_EQ(layout.requested, n);
    EXPECT_EQ(layout.view.scene.objects.size(), static_cast<std::size_t>(n));
  }
}

TEST(Layout, ImpossibleRecipesEndWithAnErrorOrAShortfall) {
  SceneRecipe crowded = scene_family("boxes");
  crowded.fewest = crowded.most = 500;
  const Layout layout = random_layout(crowded, 1, 0, kinect_v1_camera(), kinect_v1_size());
  EXPECT_EQ(layout.requested, 500);
  EXPECT_LT(layout.view.scene.objects.size(), 500u);
  SceneRecipe huge = scene_family("boxes");
  huge.object_scale = 50;
  EXPECT_THROW(random_layout(huge, 1, 0, kinect_v1_camera(), kinect_v1_size()), Error);
  SceneRecipe empty = scene_family("boxes");
  empty.mix = {};
  EXPECT_THROW(random_layout(empty, 1, 0, kinect_v1_camera(), kinect_v1_size()), Error);
  EXPECT_THROW(scene_family("pyramids"), Error);
}

TEST(Layout, TheFamilyOfOccludedScenesHidesAPartOfSomeObject) {
  const Layout layout = family_layout(scene_family("occluded"), 2, 0, kinect_v1_camera(), kinect_v1_size());
  const PosedScene posed(layout.view.scene, layout.view.T_world_camera);
  SceneTruth truth = scene_truth(layout.view, posed, render(posed, kinect_v1_camera(), kinect_v1_size()),
                                 kinect_v1_camera());
  add_occlusion(truth, layout.view, kinect_v1_camera(), kinect_v1_size());
  double most = 0;
  for (const TrueFace& face : truth.faces) most = std::max(most, face.occluded_share);
  EXPECT_GT(most, 0.15);
}

TEST(Layout, ACameraUnderTheTableIsAnError) {
  View view = plane_and_box_view();
  view.T_world_camera.origin.z = -0.1;
  EXPECT_THROW(PosedScene(view.scene, view.T_world_camera), Error);
}

TEST(Layout, ACameraInsideAnObjectIsAnError) {
  View view = plane_and_box_view();
  view.scene.objects[0].pose.origin = view.T_world_camera.origin - Vec3d{0, 0, 0.05};
  EXPECT_THROW(PosedScene(view.scene, view.T_world_camera), Error);
}

}  // namespace
}  // namespace facet
