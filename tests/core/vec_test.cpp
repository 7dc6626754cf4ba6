#include "core/vec.hpp"

#include <gtest/gtest.h>

namespace facet {
namespace {

TEST(Vec3, HasARightHandedCrossProduct) {
  EXPECT_EQ(cross({1, 0, 0}, {0, 1, 0}), (Vec3{0, 0, 1}));
  const Vec3 a{1, -2, 3}, b{0.5f, 4, -1}, c = cross(a, b);
  EXPECT_NEAR(dot(a, c), 0, 1e-6);
  EXPECT_NEAR(dot(b, c), 0, 1e-6);
  EXPECT_NEAR(dot(c, c), dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b), 1e-3);
}

TEST(Vec3, AddsSubtractsAndScales) {
  EXPECT_EQ((Vec3{1, 2, 3} + Vec3{4, 5, 6}), (Vec3{5, 7, 9}));
  EXPECT_EQ((Vec3{1, 2, 3} - Vec3{4, 5, 7}), (Vec3{-3, -3, -4}));
  EXPECT_EQ((2 * Vec3{1, 2, 3}), (Vec3{2, 4, 6}));
  EXPECT_EQ((-Vec3{1, 2, 3}), (Vec3{-1, -2, -3}));
}

TEST(Normalized, HasUnitLengthAndTheSameDirection) {
  const Vec3 unit = normalized({3, 0, -4});
  EXPECT_NEAR(norm(unit), 1, 1e-6);
  EXPECT_NEAR(unit.x, 0.6, 1e-6);
  EXPECT_NEAR(unit.z, -0.8, 1e-6);
}

TEST(Normalized, LeavesTheZeroVectorZero) {
  EXPECT_EQ(normalized({}), Vec3{});
}

}  // namespace
}  // namespace facet
