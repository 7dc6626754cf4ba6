#include "core/pixel_forest.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "core/image.hpp"
#include "core/random.hpp"

namespace facet {
namespace {

constexpr Size size{33, 9};
constexpr int count = 33 * 9;

std::vector<std::pair<int, int>> random_pairs(std::uint64_t seed, int pairs) {
  std::vector<std::pair<int, int>> list;
  for (int i = 0; i < pairs; ++i)
    list.emplace_back(random_below(count, seed, 0, static_cast<std::uint64_t>(i)),
                      random_below(count, seed, 1, static_cast<std::uint64_t>(i)));
  return list;
}

/// Names every element by the first one of its set: relabelling whole sets, without a forest.
std::vector<int> relabelled(const std::vector<std::pair<int, int>>& pairs) {
  std::vector<int> name(count);
  for (int i = 0; i < count; ++i) name[static_cast<std::size_t>(i)] = i;
  for (const auto& [a, b] : pairs) {
    const int first = name[static_cast<std::size_t>(a)], second = name[static_cast<std::size_t>(b)];
    for (int& n : name)
      if (n == first || n == second) n = std::min(first, second);
  }
  return name;
}

Image<std::int32_t> singletons() {
  Image<std::int32_t> root(size);
  for (int i = 0; i < count; ++i) root(i % size.width, i / size.width) = i;
  return root;
}

void expect_names(Image<std::int32_t>& root, const std::vector<int>& expected) {
  const PixelForest forest{root.view()};
  for (int i = 0; i < count; ++i) EXPECT_EQ(forest.find(i), expected[static_cast<std::size_t>(i)]);
  for (int i = 0; i < count; ++i) FlattenForestOp{forest}(i % size.width, i / size.width, GuardedAccess{});
  for (int i = 0; i < count; ++i)
    EXPECT_EQ(root(i % size.width, i / size.width), expected[static_cast<std::size_t>(i)]);
}

TEST(PixelForest, NamesEverySetByItsFirstPixel) {
  for (const int pairs : {0, 40, 150, 600}) {
    const auto list = random_pairs(9, pairs);
    Image<std::int32_t> root = singletons();
    for (const auto& [a, b] : list) PixelForest{root.view()}.unite(a, b);
    expect_names(root, relabelled(list));
  }
}

TEST(PixelForest, DoesNotDependOnTheOrderOfUnions) {
  auto list = random_pairs(10, 200);
  const std::vector<int> expected = relabelled(list);
  std::reverse(list.begin(), list.end());
  Image<std::int32_t> root = singletons();
  for (const auto& [a, b] : list) PixelForest{root.view()}.unite(b, a);
  expect_names(root, expected);
}

TEST(FlattenForest, LeavesPixelsThatAreInNoSet) {
  Image<std::int32_t> root(size, -1);
  FlattenForestOp{{root.view()}}(4, 4, GuardedAccess{});
  EXPECT_EQ(root(4, 4), -1);
}

}  // namespace
}  // namespace facet
