#include "score/boundary_match.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "support/masks.hpp"

namespace facet {
namespace {

std::vector<ContourPoint> points_of(const Mask& mask) {
  std::vector<ContourPoint> points;
  for (int y = 0; y < mask.height(); ++y)
    for (int x = 0; x < mask.width(); ++x)
      if (mask(x, y)) points.push_back({x, y});
  return points;
}

/// Kuhn's matching: one augmenting path after the other, over all pairs.
class PlainMatching {
 public:
  PlainMatching(const std::vector<ContourPoint>& a, const std::vector<ContourPoint>& b, double tolerance_px)
      : a_(a), b_(b), tolerance_px_(tolerance_px), a_of_b_(b.size(), -1) {}
  int solve() {
    int matched = 0;
    for (std::size_t i = 0; i < a_.size(); ++i) {
      seen_.assign(b_.size(), false);
      if (augment(static_cast<int>(i))) ++matched;
    }
    return matched;
  }

 private:
  bool augment(int i) {
    const ContourPoint p = a_[static_cast<std::size_t>(i)];
    for (std::size_t j = 0; j < b_.size(); ++j) {
      if (seen_[j] || std::hypot(p.x - b_[j].x, p.y - b_[j].y) > tolerance_px_ + 1e-9) continue;
      seen_[j] = true;
      if (a_of_b_[j] < 0 || augment(a_of_b_[j])) {
        a_of_b_[j] = i;
        return true;
      }
    }
    return false;
  }
  const std::vector<ContourPoint>&a_, &b_;
  double tolerance_px_;
  std::vector<int> a_of_b_;
  std::vector<bool> seen_;
};

TEST(BoundaryMatch, IsAsLargeAsThatOfAPlainSearchOnRandomMasks) {
  for (const Size size : {Size{1, 1}, Size{31, 7}, Size{33, 9}, Size{60, 40}}) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const auto a = points_of(seed % 2 ? random_mask(size, seed, 0.15f) : line_mask(size, seed));
      const auto b = points_of(seed % 3 ? random_mask(size, seed + 100, 0.12f) : line_mask(size, seed + 100));
      for (const double tolerance_px : {1.0, 2.0, 3.5})
        EXPECT_EQ(match_one_to_one(a, b, size, tolerance_px), PlainMatching(a, b, tolerance_px).solve())
            << size.width << "x" << size.height << " seed " << seed << " tolerance " << tolerance_px;
    }
  }
}

TEST(BoundaryMatch, FollowsAChainOfHundredsOfPixels) {
  // Every pixel of a has two neighbours in b but those at the ends; only shifting the whole chain matches
  // all.
  std::vector<ContourPoint> a, b;
  for (int i = 0; i < 300; ++i) a.push_back({2 * i + 2, 0}), b.push_back({2 * i + 1, 0});
  EXPECT_EQ(match_one_to_one(a, b, {700, 1}, 1.0), 300);
  b.push_back({601, 0});
  b.erase(b.begin());
  EXPECT_EQ(match_one_to_one(a, b, {700, 1}, 1.0), 300);
}

TEST(BoundaryMatch, GivesADoubledLineHalfThePrecisionOfASingleOne) {
  std::vector<ContourPoint> truth, doubled;
  for (int x = 0; x < 50; ++x) truth.push_back({x, 5}), doubled.push_back({x, 4}), doubled.push_back({x, 6});
  EXPECT_EQ(match_one_to_one(truth, doubled, {50, 10}, 6), 50);
}

TEST(BoundaryMatch, OfNothingIsNothing) {
  EXPECT_EQ(match_one_to_one({}, {{1, 1}}, {4, 4}, 3), 0);
  EXPECT_EQ(match_one_to_one({{1, 1}}, {}, {4, 4}, 3), 0);
}

}  // namespace
}  // namespace facet
