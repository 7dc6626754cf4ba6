#include "synth/outline.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "truth/polygon_fill.hpp"

namespace facet {
namespace {

void expect_round_trip(const Image<std::uint16_t>& ids, std::uint16_t id) {
  Image<int> filled(ids.size(), 0);
  for (const ImagePath& path : outlines(ids, id)) {
    for_each_span(path, ids.size(), [&](int y, int x0, int x1) {
      for (int x = x0; x < x1; ++x) ++filled(x, y);
    });
  }
  for (int y = 0; y < ids.height(); ++y) {
    for (int x = 0; x < ids.width(); ++x) ASSERT_EQ(filled(x, y), ids(x, y) == id) << x << " " << y;
  }
}

TEST(Outline, OfASinglePixelIsItsSquare) {
  Image<std::uint16_t> ids({3, 3}, 0);
  ids(1, 1) = 5;
  const auto paths = outlines(ids, 5);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0], (ImagePath{{0.5, 0.5}, {1.5, 0.5}, {1.5, 1.5}, {0.5, 1.5}}));
}

TEST(Outline, PixelsThatTouchByACornerAreTwoParts) {
  Image<std::uint16_t> ids({4, 4}, 0);
  ids(1, 1) = ids(2, 2) = 1;
  EXPECT_EQ(outlines(ids, 1).size(), 2u);
  expect_round_trip(ids, 1);
}

TEST(Outline, NestedHolesAndIslandsComeBackExactly) {
  Image<std::uint16_t> ids({40, 30}, 1);
  for (int y = 3; y < 27; ++y) {
    for (int x = 3; x < 37; ++x) ids(x, y) = 0;
  }
  for (int y = 6; y < 24; ++y) {
    for (int x = 6; x < 34; ++x) ids(x, y) = static_cast<std::uint16_t>((x / 3 + y / 3) % 2);
  }
  expect_round_trip(ids, 1);
  expect_round_trip(ids, 0);
}

TEST(Outline, RandomMasksComeBackExactly) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Image<std::uint16_t> ids({31, 17}, 0);
    for (int y = 0; y < 17; ++y) {
      for (int x = 0; x < 31; ++x) {
        ids(x, y) = static_cast<std::uint16_t>(random_below(static_cast<std::uint32_t>(2 + seed % 3), seed, 0,
                                                            static_cast<std::uint64_t>(y * 31 + x)));
      }
    }
    for (std::uint16_t id = 0; id < 4; ++id) expect_round_trip(ids, id);
  }
}

TEST(Outline, OfAnAbsentIdIsEmpty) {
  EXPECT_TRUE(outlines(Image<std::uint16_t>({5, 5}, 0), 3).empty());
}

}  // namespace
}  // namespace facet
