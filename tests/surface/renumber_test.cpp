#include "surface/renumber.hpp"

#include <gtest/gtest.h>
#include <utility>

#include "core/image.hpp"
#include "support/same_image.hpp"
#include "support/shuffled_grid.hpp"

namespace facet {
namespace {

TEST(Renumber, ReplacesNumbersAndLeavesWhatHasNone) {
  for (const Size size : {Size{37, 5}, {1, 1}, {64, 2}}) {
    Image<std::int32_t> image(size), expected(size), renumbered(size, 77);
    const std::vector<std::int32_t> number{7, 7, 0};
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        image(x, y) = (x + 2 * y) % 4 - 1;
        expected(x, y) = image(x, y) < 0 ? -1 : number[static_cast<std::size_t>(image(x, y))];
      }
    HostThreads one_thread;
    renumber(one_thread, std::as_const(image).view(), number, renumbered.view());
    EXPECT_TRUE(same_image(renumbered, expected));
    ShuffledGridExecutor three_threads;
    renumber(three_threads, std::as_const(image).view(), number, image.view());
    EXPECT_TRUE(same_image(image, expected)) << "in place, in parts";
  }
}

TEST(Renumber, ThereMayBeNoNumbers) {
  Image<std::int32_t> image(Size{3, 2}, -5);
  HostThreads one_thread;
  renumber(one_thread, std::as_const(image).view(), {}, image.view());
  EXPECT_TRUE(same_image(image, Image<std::int32_t>(Size{3, 2}, -1)));
}

}  // namespace
}  // namespace facet
