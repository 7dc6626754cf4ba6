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

}  // namespace
}  // namespace facet
