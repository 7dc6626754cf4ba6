#include "surface/grasp_edges.hpp"

#include <gtest/gtest.h>

#include "surface/grasp_scene.hpp"

namespace facet {
namespace {

std::vector<StraightEdge> edges_of(GraspScene& scene, double tolerance_px = 2) {
  return GraspableEdges().find(scene.face(), scene.labels.view(), scene.edges.view(), tolerance_px);
}
double length(const StraightEdge& edge) {
  return norm(edge.to - edge.from);
}
/// The longest pieces, as many as asked for.
std::vector<StraightEdge> longest(std::vector<StraightEdge> edges, std::size_t count) {
  std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return length(a) > length(b); });
  edges.resize(std::min(count, edges.size()));
  return edges;
}

TEST(GraspableEdges, ARectangleHasItsFourSidesOnTheBorderOfItsPixels) {
  GraspScene scene(facing_plane(), rectangle(0.12, 0.06));
  const auto edges = edges_of(scene);
  ASSERT_EQ(edges.size(), 4u);
  const double width_px = 0.12 * 525 / 0.8, height_px = 0.06 * 525 / 0.8;
  for (const StraightEdge& edge : edges) {
    const bool lies = std::fabs(edge.to.y - edge.from.y) < 1;
    EXPECT_NEAR(length(edge), lies ? width_px : height_px, 2.1);
    const double at = lies ? edge.from.y - 119.5 : edge.from.x - 159.5;
    EXPECT_NEAR(std::fabs(at), (lies ? height_px : width_px) / 2, 0.6);
  }
}

TEST(GraspableEdges, TheSurfaceLiesOnTheLeftOfEveryPiece) {
  for (const double turn_deg : {0.0, 17.0, 45.0, 80.0}) {
    GraspScene scene(tilted_plane(), rectangle(0.10, 0.06, turn_deg));
    for (const StraightEdge& edge : longest(edges_of(scene), 4)) {
      const Vec2 inward = normalized(left_of(edge.to - edge.from));
      EXPECT_GT(dot(Vec2{159.5, 119.5} - edge.from, inward), 5) << turn_deg;
    }
  }
}

TEST(GraspableEdges, ATurnedRectangleHasFourLongPiecesAlongItsSides) {
  for (int turn_deg = 3; turn_deg < 90; turn_deg += 7) {
    GraspScene scene(facing_plane(), rectangle(0.12, 0.08, turn_deg));
    const auto edges = edges_of(scene);
    EXPECT_LE(edges.size(), 6u) << turn_deg;
    for (const StraightEdge& edge : longest(edges, 4)) {
      const Vec2 direction = normalized(edge.to - edge.from);
      const double along = dot(direction, {std::cos(turn_deg * M_PI / 180), std::sin(turn_deg * M_PI / 180)});
      EXPECT_LT(std::min(std::fabs(along), std::sqrt(1 - along * along)), 0.05) << turn_deg;
      EXPECT_GT(length(edge), 0.07 * 525 / 0.8) << turn_deg;
    }
  }
}

TEST(GraspableEdges, ADiscIsCutIntoPiecesThatStayWithinTheTolerance) {
  for (const double diameter_m : {0.03, 0.06, 0.1}) {
    GraspScene scene(facing_plane(), disc(diameter_m));
    const auto edges = edges_of(scene);
    EXPECT_GE(edges.size(), 4u);
    EXPECT_LE(edges.size(), 16u);
    const double radius_px = diameter_m / 2 * 525 / 0.8;
    double around = 0;
    for (const StraightEdge& edge : edges) {
      around += length(edge);
      const Vec2 middle = 0.5 * (edge.from + edge.to) - Vec2{159.5, 119.5};
      EXPECT_NEAR(norm(middle), radius_px, 2.5);
    }
    EXPECT_NEAR(around, 2 * M_PI * radius_px, 0.12 * 2 * M_PI * radius_px);
  }
}

TEST(GraspableEdges, ASideThatTouchesSomethingIsLeftOut) {
  GraspScene scene(facing_plane(), rectangle(0.12, 0.06));
  scene.mark_outline(EdgeKind::concave, [](ContourPoint p) { return p.y > 138; });
  const auto edges = longest(edges_of(scene), 4);
  ASSERT_EQ(edges.size(), 3u);
  for (const StraightEdge& edge : edges) EXPECT_LT(0.5 * (edge.from.y + edge.to.y), 130);
}

TEST(GraspableEdges, AShortSlipOfTheKindDoesNotCutAnEdgeAndALongOneDoes) {
  for (const int gap_px : {5, 20}) {
    GraspScene scene(facing_plane(), rectangle(0.12, 0.06));
    scene.mark_outline(EdgeKind::concave,
                       [&](ContourPoint p) { return p.y > 130 && p.x >= 150 && p.x < 150 + gap_px; });
    EXPECT_EQ(edges_of(scene).size(), gap_px == 5 ? 4u : 5u);
  }
}

TEST(GraspableEdges, ACreaseServesTheSurfacesOnBothSidesAndADepthEdgeTheNearerOne) {
  GraspScene scene(facing_plane(), rectangle(0.12, 0.06));
  const int right = std::max_element(scene.face().contour.outer.begin(), scene.face().contour.outer.end(),
                                     [](const auto& a, const auto& b) { return a.x < b.x; })
                        ->x;
  const auto marked = [&](EdgeKind kind) {
    Image<std::uint8_t> edges(GraspScene::size, 0);
    for (int y = 95; y < 145; ++y) edges(right + 1, y) = edge_code(kind, true);  // pixels of the neighbour
    return GraspableEdges().find(scene.face(), scene.labels.view(), edges.view(), 2).size();
  };
  EXPECT_EQ(marked(EdgeKind::convex), 1u);
  EXPECT_EQ(marked(EdgeKind::depth), 0u);
}

TEST(GraspableEdges, AnOutlineWithoutGraspableEdgesHasNone) {
  GraspScene scene(facing_plane(), rectangle(0.12, 0.06));
  scene.mark_outline(EdgeKind::concave, [](ContourPoint) { return true; });
  EXPECT_TRUE(edges_of(scene).empty());
  scene.face().contour.outer = {{10, 10}};
  EXPECT_TRUE(edges_of(scene).empty());
}

}  // namespace
}  // namespace facet
