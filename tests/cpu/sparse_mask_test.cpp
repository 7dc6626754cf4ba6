#include "cpu/sparse_mask.hpp"

#include <gtest/gtest.h>

#include "core/neighbour_table.hpp"
#include "support/masks.hpp"

namespace facet {
namespace {

TEST(SparseMask, ListsTheSetPixelsInRasterOrder) {
  for_each_awkward_mask([](const Mask& mask) {
    SparseMask sparse;
    std::vector<int> pixels;
    sparse.assign(mask.view(), pixels);
    std::size_t next = 0;
    for (int y = 0; y < mask.height(); ++y)
      for (int x = 0; x < mask.width(); ++x) {
        if (!mask(x, y)) continue;
        ASSERT_LT(next, pixels.size());
        ASSERT_EQ(sparse.x(pixels[next]), x);
        ASSERT_EQ(sparse.y(pixels[next]), y);
        ASSERT_TRUE(sparse.has(pixels[next]));
        ++next;
      }
    EXPECT_EQ(next, pixels.size());
  });
}

TEST(SparseMask, KeepsNeighbourCodesUpToDateWhilePixelsAreDeleted) {
  Mask mask = random_mask({33, 9}, 3, 0.6f);
  SparseMask sparse;
  std::vector<int> pixels;
  sparse.assign(mask.view(), pixels);
  for (std::size_t i = 0; i < pixels.size(); i += 3) {
    const int x = sparse.x(pixels[i]), y = sparse.y(pixels[i]);
    mask(x, y) = 0;
    int visited = 0, expected = 0;
    for (int k = 0; k < 8; ++k) {
      const int nx = x + neighbour8(k).dx, ny = y + neighbour8(k).dy;
      expected += mask.size().contains(nx, ny) && mask(nx, ny);
    }
    sparse.remove(pixels[i], [&](int neighbour) {
      ++visited;
      EXPECT_TRUE(mask(sparse.x(neighbour), sparse.y(neighbour)));
    });
    EXPECT_EQ(visited, expected);
  }
  for (const int pixel : pixels) {
    const int x = sparse.x(pixel), y = sparse.y(pixel);
    EXPECT_EQ(sparse.has(pixel), mask(x, y) != 0);
    if (mask(x, y)) {
      EXPECT_EQ(sparse.code(pixel), neighbour_code(std::as_const(mask).view(), x, y));
    }
  }
}

TEST(SparseMask, ForgetsTheFormerMask) {
  SparseMask sparse;
  std::vector<int> pixels;
  sparse.assign(Mask(Size{33, 9}, 1).view(), pixels);
  sparse.flags(pixels[5]) = 3;
  Mask single(Size{7, 31});
  single(3, 4) = 1;
  sparse.assign(single.view(), pixels);
  ASSERT_EQ(pixels.size(), 1u);
  EXPECT_EQ(sparse.code(pixels[0]), 0u);
  EXPECT_EQ(sparse.flags(pixels[0]), 0);
}

}  // namespace
}  // namespace facet
