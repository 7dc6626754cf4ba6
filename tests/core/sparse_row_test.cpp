#include "core/sparse_row.hpp"

#include <cstddef>
#include <gtest/gtest.h>
#include <vector>

namespace facet {
namespace {

TEST(ForEachSetInRow, VisitsEveryNonZeroByteFromLeftToRight) {
  for (const int width : {0, 1, 7, 8, 9, 64, 67}) {
    std::vector<std::uint8_t> row(static_cast<std::size_t>(width));
    std::vector<int> set, visited;
    for (int x = 0; x < width; ++x)
      if (x % 11 == 0 || x == width - 1) row[static_cast<std::size_t>(x)] = 3, set.push_back(x);
    for_each_set_in_row(row.data(), width, [&](int x) { visited.push_back(x); });
    EXPECT_EQ(visited, set) << width;
  }
}

TEST(ForEachSetInRow, LooksAtAByteJustBeforeItsVisit) {
  std::vector<std::uint8_t> row(8, 1);
  std::vector<int> visited;
  for_each_set_in_row(row.data(), 8, [&](int x) {
    visited.push_back(x);
    if (x < 7) row[static_cast<std::size_t>(x + 1)] = 0;
  });
  EXPECT_EQ(visited, (std::vector<int>{0, 2, 4, 6}));
}

}  // namespace
}  // namespace facet
