#include "core/neighbour_rule.hpp"

#include <gtest/gtest.h>

namespace facet {
namespace {

TEST(OneCrossing, CountsThe4ConnectedPiecesOfClearSidesInEveryState) {
  for (unsigned code = 0; code < 256; ++code) {
    // Sides that are clear, walked round: a piece ends where the corner or the side after it is set.
    int ends = 0;
    for (unsigned side = 0; side < 8; side += 2) {
      const bool clear = !(code >> side & 1u);
      const bool corner = code >> (side + 1) & 1u, next = code >> ((side + 2) % 8) & 1u;
      if (clear && (corner || next)) ++ends;
    }
    EXPECT_EQ(one_crossing(neighbours_of(code).p) & 1u, ends == 1 ? 1u : 0u) << code;
  }
}

TEST(OneCrossing, DecidesForEveryBitOfAWordByItself) {
  for (unsigned code = 0; code < 256; ++code) {
    Neighbours<unsigned> both;  // the state in bit 0, its complement in bit 1
    for (unsigned i = 0; i < 8; ++i) both.p[i] = (code >> i & 1u) | (~code >> i & 1u) << 1;
    const unsigned expected =
        (one_crossing(neighbours_of(code).p) & 1u) | (one_crossing(neighbours_of(255u - code).p) & 1u) << 1;
    EXPECT_EQ(one_crossing(both.p) & 3u, expected) << code;
  }
}

}  // namespace
}  // namespace facet
