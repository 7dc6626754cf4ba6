#include "surface/support.hpp"

#include <gtest/gtest.h>
#include <optional>

namespace facet {
namespace {

constexpr Size size{120, 90};
const Camera camera{150, 150, 60, 45};
const Plane table{{0, -0.8f, -0.6f}, 0.6f};  // 1 m away along the optical axis
const Plane upright{{0, 0.6f, -0.8f}, 0.7f};

Plane raised(Plane plane, float by_m) {
  plane.d_m -= by_m;
  return plane;
}

struct Rect {
  int x0, y0, x1, y1;  ///< without x1, y1
};

/// Exact depth and labels of planes, drawn one over the other.
struct Scene {
  Image<std::uint16_t> labels{size, 0};
  Image<float> depth{size, 0.0f};
  Image<std::uint8_t> edges{size, 0}, filled{size, 0};
  int count = 0;
  Support support;

  void draw(int label, Rect r, const Plane& plane) {
    for (int y = r.y0; y < r.y1; ++y)
      for (int x = r.x0; x < r.x1; ++x) {
        labels(x, y) = static_cast<std::uint16_t>(label);
        depth(x, y) = -plane.d_m /
                      dot(plane.normal, camera.back_project(static_cast<float>(x), static_cast<float>(y), 1));
      }
    count = std::max(count, label);
  }
  void draw_edge(Rect r, EdgeKind kind) {
    for (int y = r.y0; y < r.y1; ++y)
      for (int x = r.x0; x < r.x1; ++x) edges(x, y) = edge_code(kind, kind != EdgeKind::concave);
  }
  /// An upright face, 30 px wide, that stands on whatever is drawn: its foot is a concave crease.
  void draw_object(int label) {
    draw(label, {45, 20, 75, 60}, upright);
    draw_edge({45, 59, 75, 60}, EdgeKind::concave);
  }
  int unite(const SupportParams& params = {}) {
    RegionPixels pixels;
    pixels.collect(labels.view(), count, depth.view(), filled.view(), camera, 1000);
    return support.unite({labels.view(), edges.view(), pixels, camera, kinect_v1_noise(), {}, 1}, params);
  }
};

Scene table_with_object() {
  Scene scene;
  scene.draw(1, {0, 0, 120, 90}, table);
  scene.draw_object(2);
  return scene;
}

TEST(Support, ItIsTheLargestPlaneThatThingsRiseFrom) {
  Scene scene = table_with_object();
  EXPECT_EQ(scene.unite(), 2);
  ASSERT_TRUE(scene.support.plane());
  EXPECT_NEAR(scene.support.plane()->d_m, table.d_m, 1e-3);
  EXPECT_EQ(scene.support.label_in(scene.labels.view()), 1);
}

TEST(Support, APlaneThatNothingStandsOnIsNone) {
  Scene scene;
  scene.draw(1, {0, 0, 120, 90}, table);
  scene.draw(2, {45, 20, 75, 60}, raised(table, 0.1f));
  scene.draw_edge({45, 20, 75, 60}, EdgeKind::depth);
  EXPECT_EQ(scene.unite(), 2);
  EXPECT_FALSE(scene.support.plane());
  EXPECT_EQ(scene.support.label_in(scene.labels.view()), 0);
}

TEST(Support, TheLidThatFacesFallAwayFromIsNone) {
  Scene scene;
  scene.draw(1, {0, 0, 120, 60}, table);
  scene.draw(2, {0, 60, 120, 90}, Plane{{0, 0.6f, -0.8f}, 0.9f});
  scene.draw_edge({0, 59, 120, 60}, EdgeKind::convex);
  scene.unite();
  EXPECT_FALSE(scene.support.plane());
}

TEST(Support, AWallIsNone) {
  Scene scene;
  scene.draw(1, {0, 0, 120, 90}, upright);
  scene.draw(2, {45, 20, 75, 60}, raised(table, 0.3f));
  scene.draw_edge({45, 59, 75, 60}, EdgeKind::concave);
  scene.unite();
  EXPECT_FALSE(scene.support.plane());
}

TEST(Support, PiecesThatAnOccluderCutsOffGetItsLabel) {
  Scene scene = table_with_object();
  scene.draw(3, {100, 0, 120, 40}, table);
  scene.draw(4, {90, 0, 100, 90}, upright);
  EXPECT_EQ(scene.unite(), 3);
  EXPECT_EQ(scene.labels(0, 0), 1);
  EXPECT_EQ(scene.labels(110, 10), 1);
  EXPECT_EQ(scene.labels(50, 30), 2);
  EXPECT_EQ(scene.labels(95, 10), 3);  // labels close up
}

TEST(Support, ABookOfOneCentimetreStaysApart) {
  Scene scene = table_with_object();
  scene.draw(3, {90, 60, 110, 80}, raised(table, 0.01f));
  EXPECT_EQ(scene.unite(), 3);
  EXPECT_EQ(scene.labels(100, 70), 3);
}

TEST(Support, ASmallSteepFaceStaysApart) {
  Scene scene = table_with_object();
  // Through the table's point at (100, 70): no offset, only tilt.
  const Vec3 foot = scene.depth(100, 70) * camera.back_project(100, 70, 1);
  const Vec3 normal = normalized(Vec3{0.5f, -0.8f, -0.6f});
  scene.draw(3, {96, 66, 104, 74}, Plane{normal, -dot(normal, foot)});
  EXPECT_EQ(scene.unite(), 3);
}

TEST(Support, FlushFacesOfOtherThingsStayApart) {
  Scene scene = table_with_object();
  scene.draw(3, {0, 60, 20, 80}, raised(table, 0.05f));
  scene.draw(4, {90, 60, 110, 80}, raised(table, 0.05f));
  EXPECT_EQ(scene.unite(), 4);
}

TEST(Support, CreasesBetweenItsPiecesVanishAndOthersStay) {
  Scene scene = table_with_object();
  scene.draw(3, {100, 60, 120, 90}, table);
  scene.draw_edge({100, 60, 101, 90}, EdgeKind::convex);
  EXPECT_EQ(scene.unite(), 2);
  EXPECT_EQ(scene.edges(100, 75), 0);
  EXPECT_EQ(scene.edges(60, 59), edge_code(EdgeKind::concave, false));
}

}  // namespace
}  // namespace facet
