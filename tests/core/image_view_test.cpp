#include "core/image_view.hpp"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>

namespace facet {
namespace {

constexpr std::array<int, 8> memory{1, 2, 3, -1, 4, 5, 6, -1};
constexpr ImageView<const int> view{memory.data(), 3, 2, 4};

TEST(ImageView, StepsOverThePaddingOfItsRows) {
  EXPECT_EQ(view(2, 0), 3);
  EXPECT_EQ(view(0, 1), 4);
  EXPECT_EQ(view.row(1), memory.data() + 4);
}

TEST(Size, ContainsItsPixelsAndNoOthers) {
  const Size size{3, 2};
  int count = 0;
  for (int y = -2; y < 5; ++y)
    for (int x = -2; x < 5; ++x) count += size.contains(x, y);
  EXPECT_EQ(count, size.area());
  EXPECT_TRUE(size.contains(0, 0));
  EXPECT_TRUE(size.contains(2, 1));
}

TEST(GuardedAccess, ContinuesTheImageWithItsNearestPixel) {
  for (int y = -5; y < 7; ++y)
    for (int x = -5; x < 8; ++x)
      EXPECT_EQ(GuardedAccess{}.clamped(view, x, y), view(std::clamp(x, 0, 2), std::clamp(y, 0, 1)));
}

TEST(GuardedAccess, ReadsZeroOutside) {
  for (int y = -3; y < 5; ++y)
    for (int x = -3; x < 6; ++x) {
      const bool inside = x >= 0 && x < 3 && y >= 0 && y < 2;
      EXPECT_EQ(GuardedAccess{}.or_zero(view, x, y), inside ? view(x, y) : 0);
    }
}

TEST(InteriorAccess, ReadsWhatGuardedAccessReadsInside) {
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) {
      EXPECT_EQ(InteriorAccess{}.clamped(view, x, y), GuardedAccess{}.clamped(view, x, y));
      EXPECT_EQ(InteriorAccess{}.or_zero(view, x, y), GuardedAccess{}.or_zero(view, x, y));
    }
}

}  // namespace
}  // namespace facet
