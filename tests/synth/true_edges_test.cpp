#include "synth/true_edges.hpp"

#include <gtest/gtest.h>

#include "synth/scene_truth.hpp"
#include "synth/shapes.hpp"

namespace facet {
namespace {

SceneTruth truth_of(const std::vector<SceneObject>& objects, double yaw_rad = 0.6) {
  View view = plane_and_box_view();
  view.scene.objects = objects;
  for (SceneObject& object : view.scene.objects) object.pose = rotation({0, 0, 1}, yaw_rad) * object.pose;
  const PosedScene posed(view.scene, view.T_world_camera);
  return scene_truth(view, posed, render(posed, kinect_v1_camera(), kinect_v1_size()), kinect_v1_camera());
}

SceneObject at(SceneObject object, Vec3d place) {
  object.pose = translation(place) * object.pose;
  return object;
}

int count(const SceneTruth& truth, EdgeKind kind, bool graspable) {
  int n = 0;
  for (const TrueEdge& edge : truth.edges) {
    n += edge.kind == kind && edge.graspable == graspable && edge.length_px >= counted_edge_px;
  }
  return n;
}

TEST(TrueEdges, ABoxWithThreeFacesInViewHasThreeCreasesFourOutlinesAndTwoContacts) {
  const SceneTruth truth = truth_of({make_box({0.15, 0.12, 0.1})});
  EXPECT_EQ(count(truth, EdgeKind::convex, true), 3);
  EXPECT_EQ(count(truth, EdgeKind::depth, true), 4);
  EXPECT_EQ(count(truth, EdgeKind::concave, false), 2);
  EXPECT_EQ(grasp_counts(truth), (GraspCounts{1, 3, 7}));
}

TEST(TrueEdges, ABoxWithTwoFacesInViewHasSixGraspableEdges) {
  EXPECT_EQ(grasp_counts(truth_of({make_box({0.15, 0.12, 0.1})}, 0)), (GraspCounts{1, 2, 6}));
}

TEST(TrueEdges, ACylinderHasTwoSilhouettesAndARimOfTwoKindsButNoFalseCrease) {
  const SceneTruth truth = truth_of({make_cylinder(0.05, 0.12)});
  EXPECT_EQ(count(truth, EdgeKind::depth, true), 3);     // two silhouettes, back of the rim
  EXPECT_EQ(count(truth, EdgeKind::convex, true), 1);    // front of the rim
  EXPECT_EQ(count(truth, EdgeKind::concave, false), 1);  // front of the foot
  EXPECT_EQ(grasp_counts(truth), (GraspCounts{1, 2, 4}));
}

TEST(TrueEdges, ABallHasOneClosedSilhouette) {
  const SceneTruth truth = truth_of({make_ball(0.06)});
  ASSERT_EQ(truth.edges.size(), 1u);
  EXPECT_EQ(truth.edges[0].kind, EdgeKind::depth);
  EXPECT_EQ(truth.edges[0].line.front(), truth.edges[0].line.back());
  EXPECT_EQ(grasp_counts(truth), (GraspCounts{1, 1, 1}));
}

TEST(TrueEdges, ACupHasARimOfTwoDepthEdgesAndAConcaveCircleInside) {
  const SceneTruth truth = truth_of({make_cup(0.06, 0.07, 0.06, false)});
  EXPECT_EQ(count(truth, EdgeKind::depth, true), 4);
  EXPECT_EQ(count(truth, EdgeKind::convex, true), 0);
  EXPECT_EQ(count(truth, EdgeKind::concave, false), 2);  // foot outside, bottom inside
}

TEST(TrueEdges, AnOccluderCutsAnEdgeIntoOnePiecePerVisiblePart) {
  const SceneObject box = make_box({0.3, 0.08, 0.08});
  const SceneTruth free = truth_of({box}, 0);
  const SceneTruth cut = truth_of({box, at(make_box({0.04, 0.04, 0.16}), {0, -0.12, 0})}, 0);
  const auto creases = [](const SceneTruth& truth) {
    int n = 0;
    for (const TrueEdge& edge : truth.edges) n += edge.object_id == 1 && edge.kind == EdgeKind::convex;
    return n;
  };
  EXPECT_EQ(creases(free), 1);
  EXPECT_EQ(creases(cut), 2);
}

TEST(TrueEdges, AtAnOcclusionTheNearerObjectOwnsTheEdge) {
  const SceneTruth truth =
      truth_of({make_box({0.3, 0.08, 0.15}), at(make_box({0.06, 0.05, 0.06}), {0, -0.12, 0})}, 0);
  for (const TrueEdge& edge : truth.edges) {
    if (edge.kind == EdgeKind::depth && edge.object_id == 2) {
      EXPECT_GE(edge.faces[0], first_face_id({.objects = {make_box({1, 1, 1})}}, 1));
    }
  }
  EXPECT_EQ(count(truth, EdgeKind::depth, true) + count(truth, EdgeKind::depth, false), 10);
}

TEST(TrueEdges, AnEdgeBesideATallerNeighbourIsNotGraspable) {
  const SceneTruth truth =
      truth_of({make_box({0.1, 0.1, 0.08}), at(make_box({0.1, 0.1, 0.16}), {0.102, 0, 0})}, 0);
  // The lower box shows top and front; its right side is a gap of 2 mm away from the higher wall.
  int beside = 0;
  for (const TrueEdge& edge : truth.edges) {
    const bool upright = std::abs(edge.line.front().x - edge.line.back().x) < 12;
    const bool right = edge.line.front().x > 330;
    if (edge.object_id == 1 && upright && right && edge.length_px > counted_edge_px) {
      ++beside;
      EXPECT_FALSE(edge.graspable) << static_cast<int>(edge.kind);
    }
  }
  EXPECT_GE(beside, 1);
  EXPECT_EQ(count(truth_of({make_box({0.1, 0.1, 0.08})}, 0), EdgeKind::depth, true), 5);
}

TEST(TrueEdges, ALeaningBoardTouchesTheBoxInAConcaveEdgeOfTheBox) {
  SceneObject box = make_box({0.12, 0.1, 0.1});
  SceneObject board = make_box({0.08, 0.02, 0.16});
  const double foot = 0.05, height = 0.1, reach = std::hypot(foot, height);
  const Vec3d rising = (1 / reach) * Vec3d{foot, 0, height}, outer = (1 / reach) * Vec3d{-height, 0, foot};
  board.pose = {cross(outer, rising), outer, rising, Vec3d{-0.06 - foot, 0, 0} + 0.01 * outer};
  const SceneTruth truth = truth_of({box, board}, 0.4);
  bool found = false;
  for (const TrueEdge& edge : truth.edges)
    found |= edge.object_id == 1 && edge.kind == EdgeKind::concave && edge.length_px > 12;
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace facet
