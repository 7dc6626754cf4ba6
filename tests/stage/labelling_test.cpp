#include "stage/labelling.hpp"

#include <gtest/gtest.h>
#include <map>
#include <opencv2/imgproc.hpp>

#include "support/every_executor.hpp"
#include "support/masks.hpp"
#include "support/mat.hpp"

namespace facet {
namespace {

template <class Executor>
Image<std::int32_t> labels_of(Executor& executor, const Image<float>& depth, const Mask& edge) {
  Image<std::int32_t> root(depth.size(), 77);
  label_components(executor, depth.view(), edge.view(), root.view());
  return root;
}

/// Every pixel named by the raster index of the first pixel of its 4-connected component by OpenCV; -1
/// elsewhere.
Image<std::int32_t> first_pixels(const Image<float>& depth, const Mask& edge) {
  Mask open =
      make_image<std::uint8_t>(depth.size(), [&](int x, int y) { return depth(x, y) > 0 && !edge(x, y); });
  cv::Mat_<int> label;
  cv::connectedComponents(as_mat(open), label, 4, CV_32S);
  std::map<int, int> first{{0, -1}};
  return make_image<std::int32_t>(depth.size(), [&](int x, int y) {
    return first.emplace(label(y, x), y * depth.width() + x).first->second;
  });
}

TEST(Labelling, IsOpenCVsPartitionWithEveryRegionNamedByItsFirstPixel) {
  CpuExecutor executor;
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    for (const Size size : {Size{1, 1}, Size{31, 7}, Size{33, 9}, Size{83, 61}}) {
      const Image<float> depth = random_depth(size, seed);
      for (const Mask& edge :
           {line_mask(size, seed), random_mask(size, seed, 0.4f), random_mask(size, seed, 0.0f)})
        EXPECT_TRUE(same_image(labels_of(executor, depth, edge), first_pixels(depth, edge)));
    }
}

TEST(Labelling, KeepsRegionsApartThatTouchAtACornerOnly) {
  const Mask edge = drawn_mask({".#.", "#.#", ".#."});
  CpuExecutor executor;
  const auto label = labels_of(executor, Image<float>(Size{3, 3}, 1.0f), edge);
  EXPECT_EQ(label(0, 0), 0);
  EXPECT_EQ(label(2, 0), 2);
  EXPECT_EQ(label(1, 1), 4);
  EXPECT_EQ(label(1, 0), -1);
}

TEST(Labelling, IsTheSameOnEveryExecutor) {
  for_each_awkward_mask([](const Mask& edge) {
    const Image<float> depth = random_depth(edge.size(), 3);
    expect_same_on_every_executor([&](auto& executor) { return labels_of(executor, depth, edge); });
  });
}

}  // namespace
}  // namespace facet
