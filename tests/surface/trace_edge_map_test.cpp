#include <gtest/gtest.h>

#include "surface/label_map.hpp"

namespace facet {
namespace {

/// A network of edges ('#') with the labels of the regions between them.
struct EdgeMap {
  Image<std::uint8_t> edge;
  Image<std::uint16_t> labels;
};

EdgeMap edge_map(std::vector<std::string> rows) {
  Image<std::uint8_t> edge({static_cast<int>(rows[0].size()), static_cast<int>(rows.size())}, 0);
  for (std::size_t y = 0; y < rows.size(); ++y)
    for (std::size_t x = 0; x < rows[y].size(); ++x)
      if (rows[y][x] == '#') {
        edge(static_cast<int>(x), static_cast<int>(y)) = 1;
        rows[y][x] = '.';
      }
  return {std::move(edge), label_map({rows.begin(), rows.end()})};
}

std::vector<Surface> traced(const EdgeMap& map) {
  std::vector<Surface> surfaces = numbered_surfaces(largest_label(map.labels));
  EdgeBorders edge_borders;
  edge_borders.follow(map.edge.view());
  trace_edge_map(edge_borders, map.labels.view(), surfaces);
  return surfaces;
}

bool touches_label(const Image<std::uint16_t>& labels, ContourPoint p, int label) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (labels.size().contains(p.x + dx, p.y + dy) && labels(p.x + dx, p.y + dy) == label) return true;
  return false;
}

TEST(TraceEdgeMap, OnlyWhatAClosedEdgeBoundsHasAContour) {
  const std::vector<Surface> surfaces = traced(edge_map({"111111111",  //
                                                         "11#####11",  //
                                                         "11#222#11",  //
                                                         "11#222#11",  //
                                                         "11#####11",  //
                                                         "111111111"}));
  EXPECT_TRUE(surfaces[0].contour.outer.empty()) << "open towards the image border";
  EXPECT_EQ(surfaces[1].contour.outer.size(), 10u) << "the corners touch no pixel of it";
  EXPECT_EQ(surfaces[1].parent, 0);
}

TEST(TraceEdgeMap, OutlinesRunOnEdgePixelsBesideTheSurface) {
  const EdgeMap map = edge_map({"..............",  //
                                ".############.",  //
                                ".#1111#2222#3#",  //
                                ".#1111#2222#3#",  //
                                ".#1111#2222#3#",  //
                                ".############.",  //
                                ".............."});
  for (const Surface& surface : traced(map)) {
    ASSERT_FALSE(surface.contour.outer.empty()) << "label " << surface.id;
    for (const ContourPoint& p : surface.contour.outer) {
      EXPECT_NE(map.edge(p.x, p.y), 0);
      EXPECT_TRUE(touches_label(map.labels, p, surface.id))
          << "label " << surface.id << " at " << p.x << " " << p.y;
    }
  }
}

TEST(TraceEdgeMap, NeighboursShareTheLineBetweenThem) {
  const std::vector<Surface> surfaces = traced(edge_map({"#########",  //
                                                         "#111#222#",  //
                                                         "#111#222#",  //
                                                         "#########"}));
  const auto runs_along = [](const Surface& surface, int x) {
    return std::count_if(surface.contour.outer.begin(), surface.contour.outer.end(),
                         [x](const ContourPoint& p) { return p.x == x && (p.y == 1 || p.y == 2); });
  };
  EXPECT_EQ(runs_along(surfaces[0], 4), 2);
  EXPECT_EQ(runs_along(surfaces[1], 4), 2);
}

TEST(TraceEdgeMap, TheHierarchyOfNestedEdgesIsKept) {
  const std::vector<Surface> surfaces = traced(edge_map({".............",  //
                                                         ".###########.",  //
                                                         ".#111111111#.",  //
                                                         ".#1###1###1#.",  //
                                                         ".#1#2#1#3#1#.",  //
                                                         ".#1###1###1#.",  //
                                                         ".#111111111#.",  //
                                                         ".###########.",  //
                                                         "............."}));
  EXPECT_EQ(surfaces[1].parent, 1);
  EXPECT_EQ(surfaces[2].parent, 1);
  std::vector<int> children = surfaces[0].children;
  std::sort(children.begin(), children.end());
  EXPECT_EQ(children, (std::vector<int>{2, 3}));
  EXPECT_EQ(surfaces[0].contour.holes.size(), 2u);
}

TEST(TraceEdgeMap, AnOpenLineBoundsNothing) {
  const std::vector<Surface> surfaces = traced(edge_map({"1111111",  //
                                                         "1#####1",  //
                                                         "1#111#1",  //
                                                         "1#1#111",  //
                                                         "1111111"}));
  EXPECT_TRUE(surfaces[0].contour.outer.empty());
}

TEST(TraceEdgeMap, AnEmptyEdgeMapGivesNoContour) {
  const std::vector<Surface> surfaces = traced(edge_map({"111", "111"}));
  EXPECT_TRUE(surfaces[0].contour.outer.empty());
  EXPECT_TRUE(surfaces[0].contour.holes.empty());
}

}  // namespace
}  // namespace facet
