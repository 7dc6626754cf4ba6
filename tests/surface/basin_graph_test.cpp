#include "surface/basin_graph.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "core/image.hpp"

namespace facet {
namespace {

constexpr Size size{12, 6};

/// The graph of the landscape's basins as they are.
BasinGraph graph_of(const BasinLandscape& landscape, int count) {
  std::vector<BasinContact> contacts;
  collect_contacts(landscape, landscape.basin, 0, landscape.basin.height, contacts);
  BasinGraph graph;
  HostThreads one_thread;
  graph.build(one_thread, landscape, landscape.basin, count, contacts);
  return graph;
}

/// Three basins side by side, each 4 px wide.
struct Columns {
  Image<std::int32_t> basin{size}, inverse_depth{size, 1000};
  Image<float> strength{size, 0.25f};
  Columns() {
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) basin(x, y) = x / 4;
  }
  BasinGraph graph(int count = 3) const {
    return graph_of({basin.view(), inverse_depth.view(), 0.001, strength.view(), 0, Camera{100, 100, 0, 0}},
                    count);
  }
};

std::vector<int> borders_of(BasinGraph& graph, int region) {
  std::vector<int> borders;
  graph.for_each_border_of(region, [&](int i) { borders.push_back(i); });
  return borders;
}

TEST(BasinGraph, KnowsPixelsStrengthsAndNeighboursOfEveryBasin) {
  Columns columns;
  columns.strength(4, 2) = 0.75f;
  BasinGraph graph = columns.graph();
  EXPECT_EQ(graph.moments(1).count(), 24);
  EXPECT_EQ(graph.moments(1).mean_q(), 1);
  ASSERT_EQ(graph.borders().size(), 2u);
  const BasinBorder& border = graph.borders()[0];
  EXPECT_EQ(border.a, 0);
  EXPECT_EQ(border.b, 1);
  EXPECT_EQ(border.length, 6);
  EXPECT_FLOAT_EQ(border.strength(), (5 * 0.25f + 0.75f) / 6);
  ASSERT_EQ(border.seam.count, 6);
  EXPECT_EQ(border.seam.x[5], 3.5f);
  EXPECT_EQ(border.seam.y[5], 5);
}

TEST(BasinGraph, ABorderNearDepthEdgesHasNoKnownStrength) {
  Columns columns;
  for (int y = 0; y < size.height - 2; ++y) columns.strength(3, y) = unknown_strength;
  BasinGraph graph = columns.graph();
  EXPECT_EQ(graph.borders()[0].known, 2);
  EXPECT_EQ(graph.borders()[0].strength(), unknown_strength);
  EXPECT_EQ(graph.borders()[1].strength(), 0.25f);
}

TEST(BasinGraph, JoinedBasinsShareTheirBorders) {
  Columns columns;
  for (int y = 3; y < size.height; ++y)
    for (int x = 0; x < 4; ++x) columns.basin(x, y) = 3;  // cut the first column in two
  BasinGraph graph = columns.graph(4);
  ASSERT_EQ(graph.borders().size(), 4u);
  std::vector<int> touched;
  graph.join(3, 0, touched);
  ASSERT_EQ(touched.size(), 1u);
  EXPECT_EQ(graph.border(touched[0]).length, 6);
  EXPECT_EQ(graph.find(3), 0);
  ASSERT_EQ(borders_of(graph, 0).size(), 1u);
  ASSERT_EQ(borders_of(graph, 1).size(), 2u);
  const BasinBorder& border = graph.border(borders_of(graph, 0)[0]);
  EXPECT_EQ(border.length, 6);
  EXPECT_EQ(border.known, 6);
  EXPECT_FLOAT_EQ(border.sum, 1.5f);
  ASSERT_EQ(border.seam.count, 6);
  EXPECT_EQ(border.seam.x[0], 3.5f);
  EXPECT_EQ(border.seam.y[0], 0);
  EXPECT_EQ(border.seam.x[5], 3.5f);
  EXPECT_EQ(border.seam.y[5], 5);
  EXPECT_EQ(graph.moments(0).count(), 24);
}

TEST(BasinGraph, ARegionThatSwallowedAllOthersHasNoBorders) {
  Columns columns;
  BasinGraph graph = columns.graph();
  std::vector<int> touched;
  graph.join(1, 2, touched);
  EXPECT_EQ(borders_of(graph, 0), borders_of(graph, 1));
  graph.join(0, 1, touched);
  EXPECT_EQ(graph.find(2), 0);
  EXPECT_TRUE(borders_of(graph, 0).empty());
  EXPECT_EQ(graph.moments(0).count(), size.area());
}

TEST(BasinGraph, ThePointsOfALongBorderAreSpreadOverIt) {
  constexpr Size tall{4, 48};
  Image<std::int32_t> basin(tall), inverse_depth(tall, 1000);
  for (int y = 0; y < tall.height; ++y)
    for (int x = 0; x < tall.width; ++x) basin(x, y) = x >= 2 ? 1 : y < 40 ? 0 : 2;
  const Image<float> strength(tall, 0.25f);
  const Image<std::uint8_t> distance(tall, 9);
  BasinGraph graph =
      graph_of({basin.view(), inverse_depth.view(), 0.001, strength.view(), 0, Camera{100, 100, 0, 0}}, 3);
  std::vector<int> touched;
  graph.join(0, 2, touched);
  ASSERT_EQ(borders_of(graph, 0).size(), 1u);
  const Seam& seam = graph.border(borders_of(graph, 0)[0]).seam;
  ASSERT_EQ(seam.count, Seam::most_points);
  const auto upper = std::count_if(seam.y.begin(), seam.y.end(), [](float y) { return y < 40; });
  EXPECT_EQ(upper, 10);  // as many per pixel above as below
}

}  // namespace
}  // namespace facet
