#include "core/angle.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace facet {
namespace {

TEST(Arctangent2, IsWithinTenMicroradiansOfTheExactAngle) {
  double worst = 0;
  for (int i = 0; i < 1000000; ++i) {
    const double angle = -M_PI + 2 * M_PI * (i + 0.5) / 1000000;
    const double radius = std::pow(10.0, i % 13 - 6);
    const auto x = static_cast<float>(radius * std::cos(angle)),
               y = static_cast<float>(radius * std::sin(angle));
    const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x));
    worst = std::max(worst, std::abs(static_cast<double>(arctangent2(y, x)) - exact));
  }
  EXPECT_LT(worst, 1e-5);
}

TEST(Arctangent2, KeepsTheFourQuadrantsApart) {
  EXPECT_NEAR(arctangent2(1, 1), M_PI / 4, 1e-5);
  EXPECT_NEAR(arctangent2(1, -1), 3 * M_PI / 4, 1e-5);
  EXPECT_NEAR(arctangent2(-1, -1), -3 * M_PI / 4, 1e-5);
  EXPECT_NEAR(arctangent2(-1, 1), -M_PI / 4, 1e-5);
}

TEST(Arctangent2, IsExactAlongTheAxes) {
  EXPECT_EQ(arctangent2(0, 2), 0.0f);
  EXPECT_EQ(arctangent2(2, 0), static_cast<float>(M_PI / 2));
  EXPECT_EQ(arctangent2(0, -2), static_cast<float>(M_PI));
  EXPECT_EQ(arctangent2(-2, 0), static_cast<float>(-M_PI / 2));
}

TEST(Arctangent2, OfTheZeroVectorIsZero) {
  EXPECT_EQ(arctangent2(0, 0), 0.0f);
}

TEST(Arctangent2, IsOddInItsFirstArgument) {
  for (int i = 1; i < 1000; ++i) {
    const float y = 0.01f * static_cast<float>(i), x = 3.0f - y;
    EXPECT_EQ(arctangent2(-y, x), -arctangent2(y, x));
  }
}

}  // namespace
}  // namespace facet
