#include "core/neighbours.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <utility>

namespace facet {
namespace {

TEST(Neighbour8, GoesOnceAroundThePixel) {
  std::set<std::pair<int, int>> seen;
  for (int i = 0; i < 8; ++i) {
    const Offset a = neighbour8(i), b = neighbour8((i + 1) % 8), opposite = neighbour8((i + 4) % 8);
    seen.insert({a.dx, a.dy});
    EXPECT_GT(a.dx * b.dy - a.dy * b.dx, 0) << "clockwise, y runs down";
    EXPECT_EQ(a.dx, -opposite.dx);
    EXPECT_EQ(a.dy, -opposite.dy);
  }
  EXPECT_EQ(seen.size(), 8u);
  EXPECT_EQ(seen.count({0, 0}), 0u);
}

TEST(Neighbour8, HasTheFourSidesAtEvenNumbers) {
  for (int i = 0; i < 8; i += 2) EXPECT_EQ(std::abs(neighbour8(i).dx) + std::abs(neighbour8(i).dy), 1);
}

TEST(Direction4Of, IsTheLineOfTheFourThatIsNearestInAngle) {
  for (int i = 0; i < 3600; ++i) {
    const double angle = (i + 0.5) * M_PI / 1800;
    const double x = 3 * std::cos(angle), y = 3 * std::sin(angle);
    int nearest = 0;
    double best = -1;
    for (int k = 0; k < 4; ++k) {
      const Offset d = direction4(k);
      const double cosine = std::abs(x * d.dx + y * d.dy) / std::hypot(d.dx, d.dy);
      if (cosine > best) best = cosine, nearest = k;
    }
    EXPECT_EQ(direction4_of(static_cast<float>(x), static_cast<float>(y)), nearest) << i / 10.0 << " degrees";
  }
}

TEST(Direction4Of, TheZeroVectorIsDefined) {
  EXPECT_EQ(direction4_of(0, 0), 0);
}

}  // namespace
}  // namespace facet
