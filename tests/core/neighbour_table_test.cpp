#include "core/neighbour_table.hpp"

#include <gtest/gtest.h>

#include "support/masks.hpp"

namespace facet {
namespace {

TEST(NeighbourTable, AnswersAsTheRuleItWasMadeFrom) {
  const auto rule = [](unsigned code) { return code % 7 == 3 || code == 255; };
  const NeighbourTable table = make_neighbour_table(rule);
  for (unsigned code = 0; code < 256; ++code) EXPECT_EQ(table[code], rule(code)) << code;
}

// Order of the bits, read off the compass: north, north-east, east, ... on a 3x3 picture.
TEST(NeighbourCode, NumbersTheNeighboursClockwiseFromTheNorth) {
  const int bit_of[3][3] = {{7, 0, 1}, {6, -1, 2}, {5, 4, 3}};
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) {
      Mask mask(Size{3, 3});
      mask(x, y) = 1;
      EXPECT_EQ(neighbour_code(mask.view(), 1, 1), bit_of[y][x] < 0 ? 0u : 1u << bit_of[y][x]);
    }
}

TEST(NeighbourCode, TakesNothingAsSetOutsideTheImage) {
  const Mask full(Size{2, 2}, 1);
  EXPECT_EQ(neighbour_code(full.view(), 0, 0), 0b00011100u);
  EXPECT_EQ(neighbour_code(full.view(), 1, 1), 0b11000001u);
  EXPECT_EQ(neighbour_code(Mask(Size{1, 1}, 1).view(), 0, 0), 0u);
}

TEST(NeighbourCode, AtTheImagesEdgeEqualsTheCodeInAZeroFrame) {
  const Mask mask = random_mask({33, 9}, 5, 0.5f);
  Mask framed(Size{35, 11});
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 33; ++x) framed(x + 1, y + 1) = mask(x, y);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 33; ++x)
      EXPECT_EQ(neighbour_code(mask.view(), x, y), neighbour_code(framed.view(), x + 1, y + 1));
}

}  // namespace
}  // namespace facet
