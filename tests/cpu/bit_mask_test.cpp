#include "cpu/bit_mask.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/neighbour_table.hpp"
#include "cpu/pack_bits.hpp"
#include "support/masks.hpp"
#include "support/mat.hpp"
#include "support/same_image.hpp"

namespace facet {
namespace {

BitMask bits_of(const Mask& mask) {
  BitMask bits;
  CpuExecutor executor;
  pack(executor, mask.view(), bits);
  return bits;
}
Mask bytes_of(const BitMask& bits) {
  Mask mask(bits.size(), 7);
  CpuExecutor executor(2);
  unpack(executor, bits, mask.view());
  return mask;
}

TEST(BitMask, GivesBackTheMaskItWasMadeOf) {
  for_each_awkward_mask([](const Mask& mask) { EXPECT_TRUE(same_image(bytes_of(bits_of(mask)), mask)); });
}

TEST(BitMask, ForgetsTheFormerMask) {
  BitMask bits = bits_of(Mask(Size{200, 9}, 1));
  Mask single(Size{65, 31});
  single(64, 4) = 1;
  CpuExecutor executor;
  pack(executor, single.view(), bits);
  EXPECT_TRUE(same_image(bytes_of(bits), single));
}

TEST(BitMask, VisitsTheSetPixelsInRasterOrder) {
  for_each_awkward_mask([](const Mask& mask) {
    std::vector<std::pair<int, int>> expected, visited;
    for (int y = 0; y < mask.height(); ++y)
      for (int x = 0; x < mask.width(); ++x)
        if (mask(x, y)) expected.emplace_back(x, y);
    for_each_set(bits_of(mask), [&](int x, int y) { visited.emplace_back(x, y); });
    EXPECT_EQ(visited, expected);
  });
}

TEST(BitMask, KnowsTheEightNeighboursOfEveryPixel) {
  const Mask mask = random_mask({131, 9}, 3, 0.5f);
  const BitMask bits = bits_of(mask);
  for (int y = 0; y < mask.height(); ++y)
    for (int x = 0; x < mask.width(); ++x) {
      const int k = x / 64;
      const auto words = neighbours_of(bits.row(y - 1) + k, bits.row(y) + k, bits.row(y + 1) + k);
      unsigned code = 0;
      for (unsigned i = 0; i < 8; ++i) code |= static_cast<unsigned>(words.p[i] >> x % 64 & 1) << i;
      ASSERT_EQ(code, neighbour_code(mask.view(), x, y)) << x << ", " << y;
    }
}

cv::Mat mat_of(Mask mask) {
  return as_mat(mask).clone();
}

TEST(BitMask, DilatesAndErodesAsOpenCVWithTheBorderContinued) {
  for_each_awkward_mask([](const Mask& mask) {
    if (mask.empty()) return;  // which OpenCV refuses
    for (const int steps : {0, 1, 5}) {
      BitMask dilated = bits_of(mask), eroded = dilated, spare;
      dilate_square(steps, dilated, spare);
      erode_square(steps, eroded, spare);
      const cv::Mat square = cv::Mat::ones(2 * steps + 1, 2 * steps + 1, CV_8U);
      cv::Mat expected;
      cv::dilate(mat_of(mask), expected, square, {-1, -1}, 1, cv::BORDER_REPLICATE);
      EXPECT_EQ(cv::norm(mat_of(bytes_of(dilated)), expected, cv::NORM_INF), 0) << steps;
      cv::erode(mat_of(mask), expected, square, {-1, -1}, 1, cv::BORDER_REPLICATE);
      EXPECT_EQ(cv::norm(mat_of(bytes_of(eroded)), expected, cv::NORM_INF), 0) << steps;
    }
  });
}

TEST(BitMask, CombinesPixelByPixel) {
  const Mask a = random_mask({131, 9}, 1, 0.5f), b = random_mask({131, 9}, 2, 0.5f);
  BitMask both = bits_of(a), either = both, first = both;
  intersect(both, bits_of(b));
  unite(either, bits_of(b));
  subtract(first, bits_of(b));
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      ASSERT_EQ(bytes_of(both)(x, y), a(x, y) & b(x, y));
      ASSERT_EQ(bytes_of(either)(x, y), a(x, y) | b(x, y));
      ASSERT_EQ(bytes_of(first)(x, y), a(x, y) & !b(x, y));
    }
}

}  // namespace
}  // namespace facet
