#include "truth/truth_map.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace facet {
namespace {

ImagePath rectangle(double x0, double y0, double x1, double y1) {
  return {{x0 - 0.5, y0 - 0.5}, {x1 - 0.5, y0 - 0.5}, {x1 - 0.5, y1 - 0.5}, {x0 - 0.5, y1 - 0.5}};
}

/// A surface of 20 x 20 pixels on a support of 50 x 40 in an image of 60 x 50.
Truth small_truth() {
  Truth truth{.size = {60, 50}};
  truth.surfaces.push_back({.number = 1, .object = 1, .parts = {{rectangle(10, 10, 30, 30), 0}}});
  truth.support.push_back({rectangle(0, 0, 50, 40), 9});
  return truth;
}

TEST(TruthMap, SupportIsItsPolygonMinusAllSurfacesAndTheRestIsBackground) {
  const TruthMap map = rasterise(small_truth(), {}, {});
  EXPECT_EQ(map.regions(9, 10), TruthRegion::support);
  EXPECT_EQ(map.regions(10, 10), TruthRegion::surface);
  EXPECT_EQ(map.surfaces(29, 29), 1);
  EXPECT_EQ(map.regions(30, 29), TruthRegion::support);
  EXPECT_EQ(map.regions(55, 45), TruthRegion::background);
  EXPECT_EQ(map.area_px[0], 400);
}

TEST(TruthMap, WhereSurfacesOverlapAPixelBelongsToTheFirstListed) {
  Truth truth = small_truth();
  truth.surfaces.push_back({.number = 2, .object = 2, .parts = {{rectangle(20, 10, 40, 30), 1}}});
  EXPECT_EQ(rasterise(truth, {}, {}).surfaces(25, 15), 1);
  truth.surfaces[1].parts[0].order = -1;
  const TruthMap map = rasterise(truth, {}, {});
  EXPECT_EQ(map.surfaces(25, 15), 2);
  EXPECT_EQ(map.area_px[0], 200);
}

TEST(TruthMap, IgnoredPixelsAreVoidEvenOnSurfaces) {
  Truth truth = small_truth();
  truth.ignore.push_back({rectangle(10, 10, 20, 30), 2});
  const TruthMap map = rasterise(truth, {}, {});
  EXPECT_EQ(map.regions(15, 15), TruthRegion::ignored);
  EXPECT_EQ(map.surfaces(15, 15), 0);
  EXPECT_EQ(map.area_px[0], 200);
}

TEST(TruthMap, ObjectPixelsThatNoSurfaceCoversAreVoid) {
  Image<std::uint16_t> masks({60, 50}, 0);
  masks(5, 5) = masks(12, 12) = 1;
  const TruthMap map = rasterise(small_truth(), masks, {});
  EXPECT_EQ(map.regions(5, 5), TruthRegion::ignored);
  EXPECT_EQ(map.regions(12, 12), TruthRegion::surface);
}

TEST(TruthMap, MissingDepthIsVoidInTheRoomButStaysTruthOnFacesAndSupport) {
  const TruthMap map = rasterise(small_truth(), {}, Image<float>({60, 50}, 0.0f));
  EXPECT_EQ(map.regions(55, 45), TruthRegion::ignored);
  EXPECT_EQ(map.regions(12, 12), TruthRegion::surface);
  EXPECT_EQ(map.regions(1, 1), TruthRegion::support);
}

TEST(TruthMap, ASurfaceUnderAHundredPixelsIsVoid) {
  Truth truth = small_truth();
  truth.surfaces.push_back({.number = 2, .object = 2, .parts = {{rectangle(35, 10, 46, 19), 1}}});
  const TruthMap map = rasterise(truth, {}, {});
  EXPECT_EQ(map.area_px[1], 99);
  EXPECT_TRUE(map.surface_counts[0]);
  EXPECT_FALSE(map.surface_counts[1]);
  EXPECT_EQ(map.regions(40, 15), TruthRegion::ignored);
}

TEST(TruthMap, ADepthImageOfAnotherSizeIsADataError) {
  EXPECT_THROW(rasterise(small_truth(), {}, Image<float>({10, 10})), Error);
}

}  // namespace
}  // namespace facet
