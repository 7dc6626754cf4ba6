#include "surface/edge_borders.hpp"

#include <gtest/gtest.h>
#include <map>
#include <opencv2/imgproc.hpp>

#include "support/masks.hpp"
#include "support/mat.hpp"

namespace facet {
namespace {

/// What tells a border from all others: a pixel begins one of a hole at most and one other.
using Key = std::tuple<int, int, bool>;

struct Found {
  Polyline points;
  Key parent{-1, -1, false};  ///< none
  bool operator==(const Found&) const = default;
};

std::map<Key, Found> followed(EdgeBorders& borders, const Mask& mask) {
  borders.follow(mask.view());
  const auto key = [](const EdgeBorder& b) { return Key{b.start.y, b.start.x, b.is_hole}; };
  std::map<Key, Found> found;
  for (const EdgeBorder& border : borders.borders()) {
    const auto points = borders.points(border);
    Found& here = found[key(border)];
    here.points.assign(points.begin(), points.end());
    if (border.parent >= 0) here.parent = key(borders.borders()[static_cast<std::size_t>(border.parent)]);
  }
  return found;
}

std::map<Key, Found> found_by_opencv(Mask mask) {
  std::vector<std::vector<cv::Point>> lines;
  std::vector<cv::Vec4i> nodes;
  cv::findContours(as_mat(mask).clone(), lines, nodes, cv::RETR_TREE, cv::CHAIN_APPROX_NONE);
  const auto key = [&](int i) {
    int depth = 0;
    for (int p = nodes[static_cast<std::size_t>(i)][3]; p >= 0; p = nodes[static_cast<std::size_t>(p)][3])
      ++depth;
    const cv::Point start = lines[static_cast<std::size_t>(i)].front();
    return Key{start.y, start.x, depth % 2 == 1};
  };
  std::map<Key, Found> found;
  for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
    Found& here = found[key(i)];
    for (const cv::Point& p : lines[static_cast<std::size_t>(i)]) here.points.push_back({p.x, p.y});
    if (const int parent = nodes[static_cast<std::size_t>(i)][3]; parent >= 0) here.parent = key(parent);
  }
  return found;
}

TEST(EdgeBorders, AreThoseThatOpenCVFindsPointForPoint) {
  EdgeBorders borders;
  for_each_awkward_mask([&](const Mask& mask) {
    if (mask.empty()) return;  // which OpenCV refuses
    EXPECT_TRUE(followed(borders, mask) == found_by_opencv(mask));
  });
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    for (const float density : {0.1f, 0.4f, 0.6f, 0.9f}) {
      const Mask mask = random_mask({37, 23}, seed, density);
      EXPECT_TRUE(followed(borders, mask) == found_by_opencv(mask)) << seed << ", " << density;
    }
}

TEST(EdgeBorders, OfAnEmptyImageAreNone) {
  EdgeBorders borders;
  borders.follow(Mask(Size{5, 3}, 1).view());
  EXPECT_EQ(borders.borders().size(), 1u);
  borders.follow(Mask().view());
  EXPECT_TRUE(borders.borders().empty());
}

}  // namespace
}  // namespace facet
