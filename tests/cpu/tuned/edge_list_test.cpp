#include "cpu/tuned/edge_list.hpp"

#include <gtest/gtest.h>

#include "support/masks.hpp"

namespace facet {
namespace {

TEST(EdgeList, HoldsTheSetPixelsInRasterOrder) {
  for_each_awkward_mask([](const Mask& mask) {
    std::vector<int> list{1, 2, 3}, expected;
    list_set_pixels(mask.view(), list);
    for (int y = 0; y < mask.height(); ++y)
      for (int x = 0; x < mask.width(); ++x)
        if (mask(x, y)) expected.push_back(listed(x, y));
    EXPECT_EQ(list, expected);
  });
}

TEST(EdgeList, VisitsEverySetNeighbourOnce) {
  const Mask mask = random_mask({33, 9}, 2, 0.5f);
  for (int i = 0; i < 33 * 9; ++i) {
    Mask visits(mask.size());
    for_each_set_neighbour(mask.view(), listed(i % 33, i / 33), [&](int x, int y) { ++visits(x, y); });
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 33; ++x) {
        const int dx = std::abs(x - i % 33), dy = std::abs(y - i / 33);
        EXPECT_EQ(visits(x, y), mask(x, y) && std::max(dx, dy) == 1 ? 1 : 0);
      }
  }
}

}  // namespace
}  // namespace facet
