#include "surface/surface_borders.hpp"

#include <gtest/gtest.h>

#include "core/edge_code.hpp"
#include "surface/label_map.hpp"

namespace facet {
namespace {

TEST(SurfaceBorders, EveryPairOfNeighboursCountsOnceWithTheKindOfItsEdge) {
  const Image<std::uint16_t> labels = label_map({"112",  //
                                                 "112",  //
                                                 "332"});
  Image<std::uint8_t> edges(labels.size(), 0);
  edges(1, 0) = edge_code(EdgeKind::convex, true);
  edges(2, 1) = edge_code(EdgeKind::depth, true);
  edges(0, 2) = edge_code(EdgeKind::concave, false);
  SurfaceBorders borders;
  borders.collect(labels.view(), edges.view(), 3);
  ASSERT_EQ(borders.all().size(), 3u);
  const SurfaceBorder& across = borders.all()[0];
  EXPECT_EQ(across.a, 1);
  EXPECT_EQ(across.b, 2);
  EXPECT_EQ(across.convex_px, 1);
  EXPECT_EQ(across.depth_px, 1);
  EXPECT_EQ(across.b_nearer_px, 1);
  EXPECT_EQ(across.a_nearer_px, 0);
}

TEST(SurfaceBorders, APairBesideAnEdgeHasItsKindAndOneWithoutIsLeftOut) {
  const Image<std::uint16_t> labels = label_map({"1122",  //
                                                 "1122",  //
                                                 "1122",  //
                                                 "1122"});
  Image<std::uint8_t> edges(labels.size(), 0);
  edges(0, 0) = edge_code(EdgeKind::concave, false);
  SurfaceBorders borders;
  borders.collect(labels.view(), edges.view(), 2);
  ASSERT_EQ(borders.all().size(), 1u);
  EXPECT_EQ(borders.all()[0].concave_px, 2);
  EXPECT_EQ(borders.all()[0].length_px(), 2);
}

TEST(SurfaceBorders, PixelsWithoutALabelHaveNone) {
  const Image<std::uint16_t> labels = label_map({"1.2"});
  SurfaceBorders borders;
  borders.collect(labels.view(), Image<std::uint8_t>(labels.size(), 0).view(), 2);
  EXPECT_TRUE(borders.all().empty());
}

}  // namespace
}  // namespace facet
