#include "core/changes.hpp"

#include <gtest/gtest.h>
#include <tuple>
#include <utility>
#include <vector>

#include "core/image.hpp"
#include "core/random.hpp"

namespace facet {
namespace {

using Change = std::tuple<int, int, bool>;

/// One neighbour after the other.
template <class T>
std::vector<Change> expected(const Image<T>& image) {
  std::vector<Change> changes;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      if (x + 1 < image.width() && image(x, y) != image(x + 1, y)) changes.emplace_back(x, y, false);
      if (y + 1 < image.height() && image(x, y) != image(x, y + 1)) changes.emplace_back(x, y, true);
    }
  return changes;
}

/// Values that rarely change along a row, some of them negative.
template <class T>
Image<T> random_image(Size size) {
  Image<T> image(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const auto place = static_cast<std::uint64_t>(y * size.width + x);
      const bool changes = x == 0 || random_uniform(1, 0, place) < 0.2;
      image(x, y) = changes ? static_cast<T>(3 * random_uniform(2, 0, place) - 1) : image(x - 1, y);
    }
  return image;
}

template <class T>
void expect_all_changes(Size size) {
  const Image<T> image = random_image<T>(size);
  std::vector<Change> visited;
  for_each_change(image.view(), [&](int x, int y, bool down) { visited.emplace_back(x, y, down); });
  EXPECT_EQ(visited, expected(image)) << size.width << " x " << size.height;
  visited.clear();
  for (const auto& [begin, end] : {std::pair(0, size.height / 2), {size.height / 2, size.height}})
    for_each_change(image.view(), begin, end,
                    [&](int x, int y, bool down) { visited.emplace_back(x, y, down); });
  EXPECT_EQ(visited, expected(image)) << "in two parts";
}

TEST(ForEachChange, VisitsWhatAComparisonOfEveryTwoNeighboursFindsInItsOrder) {
  for (const Size size : {Size{640, 9}, {511, 4}, {257, 3}, {256, 3}, {7, 7}, {1, 5}, {5, 1}, {1, 1}}) {
    expect_all_changes<std::int32_t>(size);
    expect_all_changes<std::uint16_t>(size);
  }
}

}  // namespace
}  // namespace facet
