#include "surface/regions.hpp"

#include <gtest/gtest.h>

#include "surface/label_map.hpp"

namespace facet {
namespace {

const Camera camera{500, 500, 4, 2};

/// Components named by the raster index of their first pixel, as the labelling names them.
Image<std::int32_t> roots_of(const Image<std::uint16_t>& drawn) {
  Image<std::int32_t> root(drawn.size(), -1);
  std::vector<std::int32_t> first(largest_label(drawn) + std::size_t{1}, -1);
  for (int y = 0; y < drawn.height(); ++y)
    for (int x = 0; x < drawn.width(); ++x) {
      if (drawn(x, y) == 0) continue;
      if (first[drawn(x, y)] < 0) first[drawn(x, y)] = y * drawn.width() + x;
      root(x, y) = first[drawn(x, y)];
    }
  return root;
}

struct Numbered {
  int count = 0;
  Image<std::uint16_t> labels;
  std::vector<RejectedRegion> rejected;
};

Numbered numbered(const Image<std::uint16_t>& drawn, const ValidationParams& params,
                  const Image<std::uint8_t>& filled) {
  Numbered out;
  out.labels.resize(drawn.size());
  RegionNumbering numbering;
  out.count = numbering.number(roots_of(drawn).view(), Image<float>(drawn.size(), 1.0f).view(), filled.view(),
                               camera, params, out.labels.view(), out.rejected);
  return out;
}
Numbered numbered(const Image<std::uint16_t>& drawn, const ValidationParams& params) {
  return numbered(drawn, params, Image<std::uint8_t>(drawn.size(), 0));
}

ValidationParams least_area(int px) {
  ValidationParams params;
  params.min_area_px = px;
  params.min_size_mm = 0;
  return params;
}

TEST(RegionNumbering, NumbersFollowTheRasterOrderOfFirstPixelsWithoutGaps) {
  const Numbered out = numbered(label_map({"..3333",  //
                                           "1.3.33",  //
                                           "1...2.",  //
                                           "111.22"}),
                                least_area(1));
  EXPECT_EQ(out.count, 3);
  EXPECT_EQ(out.labels(2, 0), 1);
  EXPECT_EQ(out.labels(0, 1), 2);
  EXPECT_EQ(out.labels(4, 2), 3);
  EXPECT_EQ(out.labels(1, 1), 0);
  EXPECT_TRUE(out.rejected.empty());
}

TEST(RegionNumbering, ASmallRegionIsDroppedAndTheNumbersStayDense) {
  const Numbered out = numbered(label_map({"11.3333",  //
                                           "...3333",  //
                                           "222...."}),
                                least_area(3));
  EXPECT_EQ(out.count, 2);
  EXPECT_EQ(out.labels(0, 0), 0);
  EXPECT_EQ(out.labels(3, 0), 1);
  EXPECT_EQ(out.labels(0, 2), 2);
  ASSERT_EQ(out.rejected.size(), 1u);
  EXPECT_EQ(out.rejected[0].reason, reject_reason::too_small);
  EXPECT_EQ(out.rejected[0].area_px, 2);
  EXPECT_EQ(out.rejected[0].seed, (ContourPoint{0, 0}));
}

TEST(RegionNumbering, TheLeastAreaGrowsTowardsTheCamera) {
  ValidationParams params = least_area(1);
  params.min_size_mm = 12;  // 6 px at 1 m with f = 500 px: 36 px
  EXPECT_FLOAT_EQ(least_area_px(params, camera, 1.0f), 36);
  EXPECT_FLOAT_EQ(least_area_px(params, camera, 0.5f), 144);
  params.min_area_px = 100;
  EXPECT_FLOAT_EQ(least_area_px(params, camera, 1.0f), 100);
}

TEST(RegionNumbering, AMostlyMadeUpRegionIsDropped) {
  const Image<std::uint16_t> drawn = label_map({"1111.2222"});
  Image<std::uint8_t> filled(drawn.size(), 0);
  for (const int x : {0, 1, 2, 5, 6}) filled(x, 0) = 1;  // 3 of 4, and 2 of 4
  const Numbered out = numbered(drawn, least_area(1), filled);
  EXPECT_EQ(out.count, 1);
  ASSERT_EQ(out.rejected.size(), 1u);
  EXPECT_EQ(out.rejected[0].reason, reject_reason::missing_depth);
  EXPECT_EQ(out.labels(5, 0), 1);
}

TEST(RegionNumbering, WithoutValidationEveryRegionIsKept) {
  const Image<std::uint16_t> drawn = label_map({"1.2.33"});
  ValidationParams params;
  params.enabled = false;
  const Numbered out = numbered(drawn, params, Image<std::uint8_t>(drawn.size(), 1));
  EXPECT_EQ(out.count, 3);
  EXPECT_TRUE(out.rejected.empty());
}

TEST(RegionNumbering, MoreRegionsThanTheLabelImageHoldsAreDropped) {
  Image<std::int32_t> root({601, 221});
  for (int y = 0; y < 221; ++y)
    for (int x = 0; x < 601; ++x) root(x, y) = x % 2 == 0 ? y * 601 + x : -1;
  Image<std::uint16_t> labels(root.size());
  std::vector<RejectedRegion> rejected;
  const int count = RegionNumbering().number(root.view(), Image<float>(root.size(), 1.0f).view(),
                                             Image<std::uint8_t>(root.size(), 0).view(), camera,
                                             least_area(1), labels.view(), rejected);
  EXPECT_EQ(count, 65535);
  ASSERT_EQ(rejected.size(), 301u * 221u - 65535u);
  EXPECT_EQ(rejected.back().reason, reject_reason::too_many);
  EXPECT_EQ(labels(600, 220), 0);
}

TEST(RegionNumbering, IsTheSameForASecondFrame) {
  const Image<std::uint16_t> drawn = label_map({"11.22", "11.22"});
  const Image<std::int32_t> root = roots_of(drawn);
  const Image<float> depth(drawn.size(), 1.0f);
  const Image<std::uint8_t> filled(drawn.size(), 0);
  RegionNumbering numbering;
  for (int frame = 0; frame < 2; ++frame) {
    Image<std::uint16_t> labels(drawn.size());
    std::vector<RejectedRegion> rejected;
    EXPECT_EQ(numbering.number(root.view(), depth.view(), filled.view(), camera, least_area(1), labels.view(),
                               rejected),
              2);
    EXPECT_EQ(labels(4, 1), 2);
  }
}

TEST(RegionPixels, CountsBoxesAndPointsAreThoseOfTheLabels) {
  const Image<std::uint16_t> labels = label_map({".11.", "2111", "22.."});
  Image<std::uint8_t> filled(labels.size(), 0);
  filled(1, 0) = 1;
  Image<float> depth(labels.size(), 2.0f);
  RegionPixels pixels;
  pixels.collect(labels.view(), 2, depth.view(), filled.view(), camera, 100);
  EXPECT_EQ(pixels.area_px, (std::vector<int>{5, 3}));
  EXPECT_EQ(pixels.measured_px, (std::vector<int>{4, 3}));
  EXPECT_EQ(pixels.boxes[0].x0, 1);
  EXPECT_EQ(pixels.boxes[0].x1, 3);
  EXPECT_EQ(pixels.boxes[1].y0, 1);
  EXPECT_EQ(pixels.boxes[1].y1, 2);
  ASSERT_EQ(pixels.points[0].size(), 4u);
  EXPECT_EQ(pixels.points[0].at(0), camera.back_project(2, 0, 2.0f));
}

TEST(RegionPixels, ALargeRegionIsSampledEvenlyAtMostAsOftenAsAsked) {
  const Image<std::uint16_t> labels({200, 100}, 1);
  const Image<float> depth(labels.size(), 1.0f);
  const Image<std::uint8_t> filled(labels.size(), 0);
  RegionPixels pixels;
  pixels.collect(labels.view(), 1, depth.view(), filled.view(), Camera{100, 100, 0, 0}, 1000);
  const PointSample& sample = pixels.points[0];
  EXPECT_LE(sample.size(), 1000u);
  EXPECT_GE(sample.size(), 900u);
  int left = 0, upper = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) left += sample.x[i] < 1, upper += sample.y[i] < 0.5f;
  EXPECT_NEAR(static_cast<double>(left) / static_cast<double>(sample.size()), 0.5, 0.05);
  EXPECT_NEAR(static_cast<double>(upper) / static_cast<double>(sample.size()), 0.5, 0.05);
}

TEST(RegionPixels, ForgetsThePointsOfTheFrameBefore) {
  RegionPixels pixels;
  const Image<float> depth({4, 1}, 1.0f);
  const Image<std::uint8_t> filled({4, 1}, 0);
  pixels.collect(label_map({"1122"}).view(), 2, depth.view(), filled.view(), camera, 100);
  pixels.collect(label_map({"...1"}).view(), 1, depth.view(), filled.view(), camera, 100);
  EXPECT_EQ(pixels.points[0].size(), 1u);
  EXPECT_EQ(pixels.area_px, (std::vector<int>{1}));
}

}  // namespace
}  // namespace facet
