#include "core/counting_sort.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <utility>

#include "core/random.hpp"

namespace facet {
namespace {

using Item = std::pair<int, int>;  // key, place before

std::vector<Item> random_items(int count, int key_count, std::uint64_t seed) {
  std::vector<Item> items;
  for (int i = 0; i < count; ++i)
    items.emplace_back(static_cast<int>(static_cast<float>(key_count) *
                                        random_uniform(seed, 0, static_cast<std::uint64_t>(i))),
                       i);
  return items;
}

TEST(CountingSort, OrdersAsAStableSortDoesAgainAndAgain) {
  CountingSort<Item> sort;
  for (const int count : {0, 1, 1000, 30}) {
    std::vector<Item> items = random_items(count, 17, 5);
    std::vector<Item> expected = items;
    std::stable_sort(expected.begin(), expected.end(),
                     [](const Item& l, const Item& r) { return l.first < r.first; });
    sort(items, 17, [](const Item& item) { return item.first; });
    EXPECT_EQ(items, expected) << count;
  }
}

}  // namespace
}  // namespace facet
