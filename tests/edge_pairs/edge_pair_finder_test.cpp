#include "edge_pairs/edge_pair_finder.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace facet {
namespace {

constexpr Size size{160, 120};
constexpr Camera camera{150, 150, 79.5f, 59.5f};

/// A table at 1 m that faces the camera, and on it a block whose top is at 0.9 m.
Image<float> block(int x0, int y0, int x1, int y1) {
  Image<float> depth(size, 1.0f);
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) depth(x, y) = 0.9f;
  return depth;
}

Prediction find(const Image<float>& depth, EdgePairParams params = {}) {
  params.finger_width_mm = 30;
  params.max_opening_mm = 300;
  Prediction prediction;
  EdgePairFinder(params, kinect_v1_noise()).find(depth.view(), camera, prediction);
  return prediction;
}

int count(const Image<std::uint8_t>& edges, std::uint8_t code) {
  int n = 0;
  for (int y = 0; y < edges.height(); ++y)
    for (int x = 0; x < edges.width(); ++x) n += edges(x, y) == code;
  return n;
}

TEST(EdgePairs, ABlockIsHeldAcrossItsTwoPairsOfSides) {
  const Prediction found = find(block(60, 45, 100, 75));
  EXPECT_GT(count(found.edges, edge_code(EdgeKind::depth, true)), 100);
  ASSERT_EQ(found.grasps.size(), 2u);
  // The longer sides overlap by more.
  EXPECT_NEAR(std::fabs(found.grasps[0].grasp.closing_axis.y), 1, 0.02);
  EXPECT_NEAR(found.grasps[0].grasp.width_m, 29 / 150.0 * 0.9, 0.01);
  EXPECT_NEAR(std::fabs(found.grasps[1].grasp.closing_axis.x), 1, 0.02);
  EXPECT_NEAR(found.grasps[1].grasp.width_m, 39 / 150.0 * 0.9, 0.01);
  for (const FreeGrasp& g : found.grasps) {
    EXPECT_NEAR(g.approach_axis.z, 1, 0.02);
    EXPECT_NEAR(dot(g.approach_axis, g.grasp.closing_axis), 0, 1e-5);
    for (const Vec3& contact : g.grasp.contacts_m) EXPECT_NEAR(contact.z, 0.9, 0.005);
  }
  EXPECT_EQ(found.labels(80, 60), 0);
}

TEST(EdgePairs, AHoleIsNotHeldFromInside) {
  Image<float> depth = block(0, 0, size.width, size.height);
  for (int y = 45; y < 75; ++y)
    for (int x = 60; x < 100; ++x) depth(x, y) = 1.0f;
  EXPECT_TRUE(find(depth).grasps.empty());
}

TEST(EdgePairs, ABlockWiderThanTheJawAndOneWithoutRoomBesideItAreNotHeld) {
  EXPECT_TRUE(find(block(20, 10, 140, 110)).grasps.empty());
  Image<float> depth = block(60, 45, 100, 75);
  for (int y = 20; y < 100; ++y)
    for (const int x0 : {54, 103})
      for (int x = x0; x < x0 + 3; ++x) depth(x, y) = 0.5f;
  for (const FreeGrasp& g : find(depth).grasps)
    EXPECT_GT(std::fabs(g.grasp.closing_axis.y), 0.9) << "walls stand on the left and on the right";
}

TEST(EdgePairs, TwoBlocksAreNotHeldTogether) {
  Image<float> depth = block(50, 45, 75, 75);
  for (int y = 45; y < 75; ++y)
    for (int x = 85; x < 110; ++x) depth(x, y) = 0.9f;
  for (const FreeGrasp& g : find(depth).grasps) {
    const auto [p, q] = g.grasp.contacts_px;
    EXPECT_EQ(p.x < 80, q.x < 80);
  }
}

TEST(EdgePairs, ARoofHasAConvexRidgeAndAValleyAConcaveOne) {
  Image<float> roof(size), valley(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const float slope = 0.004f * static_cast<float>(std::abs(x - 80));
      roof(x, y) = 0.8f + slope;
      valley(x, y) = 1.2f - slope;
    }
  const Prediction ridge = find(roof);
  EXPECT_GT(count(ridge.edges, edge_code(EdgeKind::convex, true)), 80);
  EXPECT_EQ(count(ridge.edges, edge_code(EdgeKind::concave, false)), 0);
  const Prediction groove = find(valley);
  EXPECT_GT(count(groove.edges, edge_code(EdgeKind::concave, false)), 80);
  EXPECT_EQ(count(groove.edges, edge_code(EdgeKind::convex, true)), 0);
}

TEST(EdgePairs, AnEmptySceneAndOneWithoutDepthHaveNone) {
  for (const float z : {1.0f, 0.0f}) {
    const Prediction found = find(Image<float>(size, z));
    EXPECT_TRUE(found.grasps.empty());
    EXPECT_FALSE(found.note.empty());
  }
  Prediction tiny;
  const Image<float> pixel(Size{1, 1}, 1.0f);
  EdgePairFinder({}, kinect_v1_noise()).find(pixel.view(), camera, tiny);
  EXPECT_TRUE(tiny.grasps.empty());
}

}  // namespace
}  // namespace facet
