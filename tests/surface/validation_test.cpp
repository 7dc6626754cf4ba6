#include "surface/validation.hpp"

#include <gtest/gtest.h>

namespace facet {
namespace {

/// A surface of which only what the validation looks at is set.
Surface surface_of(int area_px, std::size_t outline_px) {
  Surface surface;
  surface.area_px = area_px;
  surface.contour.outer.resize(outline_px);
  return surface;
}

TEST(Validation, ACompactMeasuredSurfaceIsKept) {
  EXPECT_EQ(validate_surface({}, surface_of(400, 76), 1.0f), "");
}

TEST(Validation, ASurfaceWithoutClosedContourIsOpenEvenWhenTheChecksAreOff) {
  ValidationParams off;
  off.enabled = false;
  EXPECT_EQ(validate_surface({}, surface_of(400, 0), 1.0f), reject_reason::open_contour);
  EXPECT_EQ(validate_surface(off, surface_of(400, 0), 1.0f), reject_reason::open_contour);
}

TEST(Validation, ANarrowSurfaceIsASliver) {
  ValidationParams params;
  params.min_width_px = 3;
  EXPECT_EQ(validate_surface(params, surface_of(100, 68), 1.0f),
            reject_reason::sliver);                                    // mean width 2.94 px
  EXPECT_EQ(validate_surface(params, surface_of(100, 66), 1.0f), "");  // 3.03 px
}

TEST(Validation, TheOutlinesOfHolesCountTowardsThePerimeter) {
  Surface ring = surface_of(100, 40);
  ring.contour.holes.emplace_back(40);
  EXPECT_EQ(validate_surface({}, ring, 1.0f), reject_reason::sliver);
}

TEST(Validation, AMostlyMadeUpSurfaceIsMissingDepth) {
  EXPECT_EQ(validate_surface({}, surface_of(400, 76), 0.49f), reject_reason::missing_depth);
  EXPECT_EQ(validate_surface({}, surface_of(400, 76), 0.5f), "");
}

TEST(Validation, SwitchedOffItKeepsSliversAndMadeUpDepth) {
  ValidationParams off;
  off.enabled = false;
  EXPECT_EQ(validate_surface(off, surface_of(10, 30), 0.0f), "");
  EXPECT_FLOAT_EQ(least_area_px(off, Camera{500, 500, 0, 0}, 1.0f), 1);
}

}  // namespace
}  // namespace facet
