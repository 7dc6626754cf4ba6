#include "core/image.hpp"

#include <cstdint>
#include <gtest/gtest.h>
#include <utility>

#include "core/vec.hpp"
#include "support/same_image.hpp"

namespace facet {
namespace {

template <class T>
void expect_aligned_rows() {
  for (const Size size : {Size{1, 1}, Size{31, 7}, Size{64, 2}, Size{631, 479}}) {
    Image<T> image(size);
    EXPECT_GE(image.stride(), size.width);
    for (int y = 0; y < size.height; ++y)
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(image.row(y)) % 64, 0u) << "row " << y;
  }
}

TEST(Image, StartsEveryRowOnACacheLine) {
  expect_aligned_rows<std::uint8_t>();
  expect_aligned_rows<std::uint16_t>();
  expect_aligned_rows<std::int32_t>();
  expect_aligned_rows<float>();
}

TEST(Image, PadsRowsToACacheLineAndNoFurther) {
  EXPECT_EQ(Image<std::uint8_t>(Size{631, 2}).stride(), 640);
  EXPECT_EQ(Image<float>(Size{631, 2}).stride(), 640);
  EXPECT_EQ(Image<float>(Size{33, 2}).stride(), 48);
}

TEST(Image, StartsAsZeroAndHoldsWhatIsWritten) {
  Image<int> image(Size{33, 9});
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 33; ++x) {
      EXPECT_EQ(image(x, y), 0);
      image(x, y) = 100 * y + x;
    }
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 33; ++x) EXPECT_EQ(std::as_const(image)(x, y), 100 * y + x);
}

TEST(Image, KeepsItsMemoryWhenItShrinksAndGrowsBack) {
  Image<float> image(Size{640, 480});
  const float* memory = image.row(0);
  image.resize({31, 7});
  EXPECT_EQ(image.row(0), memory);
  EXPECT_EQ(image.size(), (Size{31, 7}));
  image.resize({640, 480});
  EXPECT_EQ(image.row(0), memory);
}

TEST(Image, KeepsItsContentsWhenResizedToItsOwnSize) {
  Image<float> image(Size{31, 7}, 2.5f);
  image.resize({31, 7});
  EXPECT_EQ(image(30, 6), 2.5f);
}

TEST(Image, ForgetsItsContentsWhenResizedToAnotherSize) {
  Image<float> image(Size{31, 7}, 2.5f);
  image.resize({30, 7});
  EXPECT_EQ(image(0, 0), 0.0f);
}

TEST(Image, IsCopiedDeeply) {
  Image<int> original(Size{33, 9}, 4);
  Image<int> copy = original, assigned;
  assigned = original;
  original(3, 3) = 5;
  EXPECT_EQ(copy(3, 3), 4);
  EXPECT_EQ(assigned(3, 3), 4);
  EXPECT_EQ(copy(32, 8), 4);
}

TEST(Image, SurvivesAssignmentToItself) {
  Image<int> image(Size{5, 5}, 4);
  const Image<int>& same = image;
  image = same;
  EXPECT_EQ(image(4, 4), 4);
}

TEST(Image, MovesWithoutCopying) {
  Image<int> original(Size{33, 9}, 4);
  const int* memory = original.row(0);
  Image<int> moved = std::move(original);
  EXPECT_EQ(moved.row(0), memory);
  EXPECT_EQ(moved.size(), (Size{33, 9}));
}

TEST(Image, WithoutPixelsIsEmptyWhicheverSideIsZero) {
  for (const Size size : {Size{0, 0}, Size{0, 7}, Size{7, 0}, Size{-1, 3}}) {
    Image<float> image(size, 1.0f);
    EXPECT_TRUE(image.empty());
    EXPECT_EQ(image.size(), Size{});
    EXPECT_TRUE(Image<float>(image).empty());
  }
}

TEST(Image, SharesItsPixelsWithItsView) {
  Image<int> image(Size{33, 9});
  image.view()(32, 8) = 7;
  EXPECT_EQ(image(32, 8), 7);
  EXPECT_EQ(std::as_const(image).view()(32, 8), 7);
  EXPECT_EQ(image.view().stride, image.stride());
}

TEST(Image, HoldsPixelsThatAreNoPowerOfTwo) {
  Image<Vec3> image(Size{7, 3}, Vec3{1, 2, 3});
  EXPECT_EQ(image(6, 2), (Vec3{1, 2, 3}));
  EXPECT_EQ(image.row(2), image.row(0) + 2 * image.stride());
}

}  // namespace
}  // namespace facet
