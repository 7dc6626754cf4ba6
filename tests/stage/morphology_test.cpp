#include "stage/morphology.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "support/every_executor.hpp"
#include "support/masks.hpp"
#include "support/mat.hpp"
#include "support/topology.hpp"

namespace facet {
namespace {

template <class Executor>
Mask smoothed(Executor& executor, const MorphologyParams& params, const Mask& mask) {
  Mask edge = mask, a(mask.size(), 9), b(mask.size(), 9);
  morphology(executor, params, edge.view(), a.view(), b.view());
  return edge;
}
Mask smoothed(const MorphologyParams& params, const Mask& mask) {
  CpuExecutor executor;
  return smoothed(executor, params, mask);
}

Mask from_mat(const cv::Mat& mat) {
  return make_image<std::uint8_t>({mat.cols, mat.rows},
                                  [&](int x, int y) { return mat.at<std::uint8_t>(y, x); });
}
cv::Mat square(int side_px) {
  return cv::getStructuringElement(cv::MORPH_RECT, {side_px, side_px});
}
cv::Mat opened(const cv::Mat& mask, int side_px) {
  cv::Mat out;
  cv::morphologyEx(mask, out, cv::MORPH_OPEN, square(side_px));
  return out;
}

TEST(Morphology, OpeningIsOpenCVsByTheSquare) {
  CpuExecutor executor;
  for (const int side_px : {3, 5, 11}) {
    Mask mask = blob_mask({83, 61}, 6, 14), scratch(mask.size());
    const Mask expected = from_mat(opened(as_mat(mask), side_px));
    ImageView<std::uint8_t> view = mask.view(), spare = scratch.view();
    open_square(executor, side_px, view, spare);
    EXPECT_TRUE(same_image(mask, expected)) << side_px;
  }
}

TEST(Morphology, BridgeIsOpenCVsDilation) {
  for (const int bridge_px : {0, 1, 3}) {
    Mask mask = line_mask({83, 61}, 6);
    cv::Mat expected;
    cv::dilate(as_mat(mask), expected, square(2 * bridge_px + 1));
    EXPECT_TRUE(same_image(smoothed({MorphologyMode::bridge, bridge_px}, mask), from_mat(expected)));
  }
}

TEST(Morphology, BandPassIsTheDifferenceOfTwoOpeningsOfTheDilatedContours) {  // eqs 7-9
  for (Mask mask : {line_mask({83, 61}, 6), blob_mask({83, 61}, 2, 20)}) {
    cv::Mat thick;
    cv::dilate(as_mat(mask), thick, square(3));
    const cv::Mat expected = opened(thick, 3) & ~(opened(thick, 11) * 255);
    EXPECT_TRUE(same_image(smoothed({MorphologyMode::paper, 0, 3, 11}, mask), from_mat(expected)));
  }
}

TEST(Morphology, UndilatedLinesVanishUnderTheOpeningsOfEquations7To9) {
  CpuExecutor executor;
  Mask line(Size{33, 9}), scratch(line.size());
  for (int x = 2; x < 31; ++x) line(x, 4) = 1;
  const Mask kept = smoothed({MorphologyMode::paper, 0, 3, 11}, line);
  for (int x = 2; x < 31; ++x) EXPECT_EQ(kept(x, 4), 1) << "so the band-pass dilates first";
  ImageView<std::uint8_t> view = line.view(), spare = scratch.view();
  open_square(executor, 3, view, spare);
  EXPECT_EQ(count_set(line), 0);
}

TEST(Morphology, BandPassDropsWhatIsAsThickAsTheLargeElement) {
  const auto bars =
      make_image<std::uint8_t>({100, 60}, [](int x, int) { return (x >= 10 && x < 30) || x == 60; });
  const Mask kept = smoothed({MorphologyMode::paper, 0, 3, 11}, bars);
  EXPECT_EQ(kept(20, 30), 0);
  EXPECT_EQ(kept(60, 30), 1);
}

TEST(Morphology, BridgeClosesGapsUpToTwiceItsReach) {
  for (const int gap_px : {2, 3}) {
    const auto broken = make_image<std::uint8_t>(
        {40, 9}, [&](int x, int y) { return y == 4 && (x < 20 || x >= 20 + gap_px); });
    EXPECT_EQ(topology_of(smoothed({MorphologyMode::bridge, 1}, broken)).lines, gap_px <= 2 ? 1 : 2);
  }
}

TEST(Morphology, ModeNoneLeavesTheEdgesAsTheyAre) {
  const Mask mask = line_mask({33, 9}, 1);
  EXPECT_TRUE(same_image(smoothed({MorphologyMode::none}, mask), mask));
}

TEST(Unite, IsTheUnionOfBothMasks) {
  const Mask a = random_mask({33, 9}, 1, 0.3f), b = random_mask({33, 9}, 2, 0.3f);
  Mask both(a.size());
  CpuExecutor executor;
  unite(executor, a.view(), b.view(), both.view());
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 33; ++x) EXPECT_EQ(both(x, y), a(x, y) || b(x, y) ? 1 : 0);
}

TEST(Morphology, IsTheSameOnEveryExecutor) {
  for_each_awkward_mask([](const Mask& mask) {
    expect_same_on_every_executor([&](auto& executor) {
      return smoothed(executor, {MorphologyMode::bridge, 2}, mask);
    });
    if (mask.width() > 100) return;  // eleven passes and more: slow on the shuffled grid
    expect_same_on_every_executor([&](auto& executor) {
      return smoothed(executor, {MorphologyMode::paper, 0, 3, 11}, mask);
    });
  });
}

}  // namespace
}  // namespace facet
