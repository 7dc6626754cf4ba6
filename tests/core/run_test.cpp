#include "core/run.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace facet {
namespace {

template <class T>
class EndOfRun : public testing::Test {};
using PixelTypes = testing::Types<std::uint8_t, std::uint16_t, std::int32_t>;
TYPED_TEST_SUITE(EndOfRun, PixelTypes);

TYPED_TEST(EndOfRun, IsTheFirstPixelThatDiffersOrTheEndOfTheRow) {
  for (int width = 1; width < 40; ++width)
    for (int change = 1; change <= width; ++change) {
      std::vector<TypeParam> row(static_cast<std::size_t>(width), 3);
      if (change < width) row[static_cast<std::size_t>(change)] = 4;
      for (int from = 0; from < change; ++from)
        ASSERT_EQ(end_of_run<TypeParam>(row.data(), from, width, 3), change);
      ASSERT_EQ(end_of_run<TypeParam>(row.data(), 0, width, 9), 0);
    }
}

}  // namespace
}  // namespace facet
