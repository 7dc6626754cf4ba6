#include "surface/object_grouping.hpp"

#include <gtest/gtest.h>

#include "surface/label_map.hpp"

namespace facet {
namespace {

const Camera camera{500, 500, 4, 3};

/// Edge codes drawn as rows of characters: 'd' depth, 'v' convex, 'c' concave.
Image<std::uint8_t> edge_map(const std::vector<std::string_view>& rows) {
  Image<std::uint8_t> edges({static_cast<int>(rows[0].size()), static_cast<int>(rows.size())}, 0);
  for (int y = 0; y < edges.height(); ++y)
    for (int x = 0; x < edges.width(); ++x)
      switch (rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]) {
        case 'd':
          edges(x, y) = edge_code(EdgeKind::depth, true);
          break;
        case 'v':
          edges(x, y) = edge_code(EdgeKind::convex, true);
          break;
        case 'c':
          edges(x, y) = edge_code(EdgeKind::concave, false);
          break;
        default:
          break;
      }
  return edges;
}

/// Points on a paraboloid about the optical axis, 1 m away, with the given curvature.
PointSample bent_points(double curvature_per_m) {
  PointSample points;
  for (int i = -10; i <= 10; ++i)
    for (int k = -10; k <= 10; ++k) {
      const float x = 0.003f * static_cast<float>(i), y = 0.003f * static_cast<float>(k);
      points.add({x, y, 1 - static_cast<float>(curvature_per_m) / 2 * (x * x + y * y)});
    }
  return points;
}

struct Grouped {
  Image<std::uint16_t> labels;
  Image<std::uint8_t> edges;
  std::vector<Surface> surfaces;
  std::vector<PointSample> points;
  int support = 0;
  std::optional<Plane> support_plane{};

  Grouped(const std::vector<std::string_view>& label_rows, const std::vector<std::string_view>& edge_rows)
      : labels(label_map(label_rows)),
        edges(edge_map(edge_rows)),
        surfaces(numbered_surfaces(largest_label(labels))),
        points(surfaces.size(), bent_points(0)) {}

  std::vector<int> objects(const ObjectParams& params = {}) {
    ObjectGrouping grouping;
    grouping.group({labels.view(), edges.view(), points, camera, support, support_plane}, params, surfaces);
    std::vector<int> objects;
    for (const Surface& surface : surfaces) objects.push_back(surface.object);
    return objects;
  }
};

TEST(ObjectGrouping, ConvexCreasesJoinAndConcaveOnesPart) {
  Grouped scene({"111111", "111111", "222222", "222222", "333333", "333333"},
                {"......", "vvvvvv", "......", "......", "cccccc", "......"});
  EXPECT_EQ(scene.objects(), (std::vector<int>{1, 1, 3}));
}

TEST(ObjectGrouping, DepthEdgesPart) {
  Grouped scene({"111111", "111111", "222222", "222222"}, {"......", "dddddd", "......", "......"});
  EXPECT_EQ(scene.objects(), (std::vector<int>{1, 2}));
}

TEST(ObjectGrouping, TheMajorityOfABorderDecides) {
  Grouped mostly_convex({"11111111", "22222222"}, {"vvvvvvcc", "........"});
  EXPECT_EQ(mostly_convex.objects(), (std::vector<int>{1, 1}));
  Grouped mostly_concave({"11111111", "22222222"}, {"vvvccccc", "........"});
  EXPECT_EQ(mostly_concave.objects(), (std::vector<int>{1, 2}));
  Grouped mostly_depth({"1111111111", "2222222222"}, {"vvvvdddddd", ".........."});
  EXPECT_EQ(mostly_depth.objects(), (std::vector<int>{1, 2}));
}

TEST(ObjectGrouping, TheLeastIdNamesAGroupOfMany) {
  Grouped scene({"1122", "1122", "1122", "1122", "1122", "1122", "3333"},
                {".v..", ".v..", ".v..", ".v..", "....", "....", "...."});
  EXPECT_EQ(scene.objects(), (std::vector<int>{1, 1, 3}));
  Grouped chain({"22221111", "22221111", "22221111", "22221111", "33333333"},
                {"...v....", "...v....", "...v....", "vvvvvvvv", "........"});
  EXPECT_EQ(chain.objects(), (std::vector<int>{1, 1, 1}));
}

TEST(ObjectGrouping, TheSupportIsNoObjectAndJoinsNone) {
  Grouped scene({"111111", "111111", "222222", "222222", "333333"},
                {"......", "vvvvvv", "......", "vvvvvv", "......"});
  scene.support = 2;
  EXPECT_EQ(scene.objects(), (std::vector<int>{1, 0, 3}));
}

TEST(ObjectGrouping, WhatLeavesTheImageBehindTheSupportIsNoObject) {
  Grouped scene({"111111", "222222"}, {"dddddd", "......"});
  scene.support_plane = Plane{{0, 0, -1}, 0.9f};
  scene.surfaces[1].touches_border = true;
  EXPECT_EQ(scene.objects(), (std::vector<int>{1, 0}));
}

TEST(ObjectGrouping, AHollowInsideBelongsToTheOutsideThatHidesPartOfIt) {
  Grouped cup({".....", "11111", "22222", "22222"}, {".....", ".....", "ddddd", "....."});
  cup.surfaces[0].curved = cup.surfaces[1].curved = true;
  cup.points = {bent_points(-20), bent_points(20)};  // hollow behind bulging
  EXPECT_EQ(cup.objects(), (std::vector<int>{1, 2})) << "the outside is hollow";
  cup.points = {bent_points(20), bent_points(-20)};
  EXPECT_EQ(cup.objects(), (std::vector<int>{1, 1}));
  ObjectParams off;
  off.hollow = false;
  EXPECT_EQ(cup.objects(off), (std::vector<int>{1, 2}));
  cup.points = {bent_points(-20), bent_points(-20)};
  EXPECT_EQ(cup.objects(), (std::vector<int>{1, 2})) << "two balls";
}

}  // namespace
}  // namespace facet
