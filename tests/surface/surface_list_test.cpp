#include "surface/surface_list.hpp"

#include <gtest/gtest.h>

#include "surface/label_map.hpp"

namespace facet {
namespace {

/// Four nested frames around one another, 1 outermost; label n holds n points.
struct NestedSurfaces {
  Image<std::uint16_t> labels = label_map({"1111111",  //
                                           "1222221",  //
                                           "1233321",  //
                                           "1234321",  //
                                           "1233321",  //
                                           "1222221",  //
                                           "1111111"});
  Image<std::uint8_t> edges{labels.size(), 0};
  RegionPixels pixels;
  std::vector<Surface> surfaces = numbered_surfaces(4);
  std::vector<RejectedRegion> rejected;

  NestedSurfaces() {
    const Image<float> depth(labels.size(), 1.0f);
    pixels.collect(labels.view(), 4, depth.view(), Image<std::uint8_t>(labels.size(), 0).view(),
                   Camera{10, 10, 3, 3}, 100);
    trace_regions(labels.view(), pixels.boxes, surfaces);
    describe_surfaces(pixels, labels.size(), edges.view(), surfaces);
  }
  void drop(const ValidationParams& params) {
    drop_invalid_surfaces(params, pixels, labels.view(), surfaces, rejected);
  }
};

ValidationParams tolerant() {
  ValidationParams params;
  params.min_width_px = 0;
  params.min_valid_share = 0;
  return params;
}

TEST(SurfaceList, AreaBorderAndGraspabilityAreDescribed) {
  NestedSurfaces frame;
  frame.edges(1, 1) = edge_code(EdgeKind::convex, true);    // on the outline of 2
  frame.edges(2, 2) = edge_code(EdgeKind::concave, false);  // on that of 3, out of reach
  describe_surfaces(frame.pixels, frame.labels.size(), frame.edges.view(), frame.surfaces);
  EXPECT_EQ(frame.surfaces[0].area_px, 24);
  EXPECT_EQ(frame.surfaces[3].area_px, 1);
  EXPECT_TRUE(frame.surfaces[0].touches_border);
  EXPECT_FALSE(frame.surfaces[1].touches_border);
  EXPECT_FALSE(frame.surfaces[0].graspable);
  EXPECT_TRUE(frame.surfaces[1].graspable);
  EXPECT_FALSE(frame.surfaces[2].graspable);
}

TEST(SurfaceList, NothingIsDroppedWhereEverythingIsValid) {
  NestedSurfaces frame;
  frame.drop(tolerant());
  EXPECT_EQ(frame.surfaces.size(), 4u);
  EXPECT_TRUE(frame.rejected.empty());
  EXPECT_EQ(frame.labels(3, 3), 4);
}

TEST(SurfaceList, DroppingRenumbersIdsLabelsParentsChildrenAndPoints) {
  NestedSurfaces frame;
  frame.pixels.measured_px[1] = 0;  // surface 2 is made up
  const std::size_t points_of_3 = frame.pixels.points[2].size();
  ValidationParams params = tolerant();
  params.min_valid_share = 0.5f;
  frame.drop(params);

  ASSERT_EQ(frame.surfaces.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(frame.surfaces[static_cast<std::size_t>(i)].id, i + 1);
  EXPECT_EQ(frame.labels(0, 0), 1);
  EXPECT_EQ(frame.labels(1, 1), 0);
  EXPECT_EQ(frame.labels(2, 2), 2);
  EXPECT_EQ(frame.labels(3, 3), 3);
  EXPECT_EQ(frame.surfaces[1].parent, 1) << "the child of a dropped surface goes to its parent";
  EXPECT_EQ(frame.surfaces[2].parent, 2);
  EXPECT_EQ(frame.surfaces[0].children, (std::vector<int>{2}));
  EXPECT_EQ(frame.surfaces[1].children, (std::vector<int>{3}));
  EXPECT_EQ(frame.pixels.points[1].size(), points_of_3);
  ASSERT_EQ(frame.rejected.size(), 1u);
  EXPECT_EQ(frame.rejected[0].reason, reject_reason::missing_depth);
  EXPECT_EQ(frame.rejected[0].area_px, 16);
}

TEST(SurfaceList, TheSeedOfADroppedSurfaceIsItsFirstPixel) {
  NestedSurfaces frame;
  frame.labels = label_map({"..1", "111"});
  const Image<float> depth(frame.labels.size(), 1.0f);
  frame.pixels.collect(frame.labels.view(), 1, depth.view(),
                       Image<std::uint8_t>(frame.labels.size(), 1).view(), Camera{10, 10, 1, 1}, 100);
  frame.surfaces = numbered_surfaces(1);
  trace_regions(frame.labels.view(), frame.pixels.boxes, frame.surfaces);
  ValidationParams params = tolerant();
  params.min_valid_share = 0.5f;
  frame.drop(params);
  ASSERT_EQ(frame.rejected.size(), 1u);
  EXPECT_EQ(frame.rejected[0].seed, (ContourPoint{2, 0}));
}

TEST(SurfaceList, ThePointsOfTheKeptFollowThemWhenSeveralAreDropped) {
  NestedSurfaces frame;
  frame.pixels.measured_px[0] = 0;
  frame.pixels.measured_px[2] = 0;
  const Vec3 first_of_2 = frame.pixels.points[1].at(0), first_of_4 = frame.pixels.points[3].at(0);
  ValidationParams params = tolerant();
  params.min_valid_share = 0.5f;
  frame.drop(params);
  ASSERT_EQ(frame.surfaces.size(), 2u);
  EXPECT_EQ(frame.pixels.points[0].at(0), first_of_2);
  EXPECT_EQ(frame.pixels.points[1].at(0), first_of_4);
  EXPECT_EQ(frame.surfaces[0].parent, 0);
  EXPECT_EQ(frame.surfaces[1].parent, 1);
}

TEST(SurfaceList, AFrameWithoutSurfacesSaysWhy) {
  Image<float> depth({3, 2}, 0.0f);
  EXPECT_EQ(why_nothing_was_found(depth.view(), {}), "the frame has no measured depth");
  depth(1, 1) = 0.7f;
  EXPECT_EQ(why_nothing_was_found(depth.view(), {}), "every measured pixel is an edge");
  const std::vector<RejectedRegion> rejected{{{0, 0}, 3, "sliver"}, {{2, 0}, 1, "too_small"}};
  EXPECT_EQ(why_nothing_was_found(depth.view(), rejected), "all 2 regions were dropped, the first as sliver");
}

}  // namespace
}  // namespace facet
