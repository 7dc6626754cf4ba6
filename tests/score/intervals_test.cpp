#include "score/intervals.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace facet {
namespace {

TEST(Intervals, WilsonHasItsKnownValues) {
  // R: binom::binom.confint(x, n, methods = "wilson")
  const Interval half = wilson_interval(5, 10);
  EXPECT_NEAR(half.lo, 0.2365931, 1e-6);
  EXPECT_NEAR(half.hi, 0.7634069, 1e-6);
  const Interval none = wilson_interval(0, 10);
  EXPECT_DOUBLE_EQ(none.lo, 0);
  EXPECT_NEAR(none.hi, 0.2775328, 1e-6);
  const Interval all = wilson_interval(52, 52);
  EXPECT_NEAR(all.lo, 0.9312, 1e-4);
  EXPECT_DOUBLE_EQ(all.hi, 1);
}

TEST(Intervals, ResamplesAreTheSameForTheSameSeedAndDrawWithReplacement) {
  const std::vector<std::string> frames(20);
  std::vector<std::vector<int>> first, second;
  for_each_resample(frames, {50, 3}, [&](const std::vector<int>& f) { first.push_back(f); });
  for_each_resample(frames, {50, 3}, [&](const std::vector<int>& f) { second.push_back(f); });
  EXPECT_EQ(first, second);
  ASSERT_EQ(first.size(), 50u);
  std::vector<int> drawn(20, 0);
  for (const auto& replicate : first) {
    EXPECT_EQ(replicate.size(), 20u);
    for (const int frame : replicate) ++drawn[static_cast<std::size_t>(frame)];
  }
  for (const int count : drawn) EXPECT_GT(count, 20);  // 50 expected
}

TEST(Intervals, FramesOfASequenceAreDrawnTogether) {
  const std::vector<std::string> sequences{"a", "a", "a", "b", "b", "b"};
  int mixed = 0;
  for_each_resample(sequences, {200, 1}, [&](const std::vector<int>& frames) {
    ASSERT_EQ(frames.size(), 6u);
    int from_a = 0;
    for (const int frame : frames) from_a += frame < 3;
    EXPECT_EQ(from_a % 3, 0);
    mixed += from_a == 3;
  });
  EXPECT_GT(mixed, 60);
  EXPECT_LT(mixed, 140);
}

TEST(Intervals, PercentilesLieBetweenOrderStatistics) {
  std::vector<double> values(101);
  std::iota(values.begin(), values.end(), 0.0);
  const auto interval = percentile_interval(values);
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->lo, 2.5, 1e-12);
  EXPECT_NEAR(interval->hi, 97.5, 1e-12);
  EXPECT_FALSE(percentile_interval({}));
}

TEST(Intervals, QuantilesLieBetweenOrderStatistics) {
  const std::vector<double> sorted{1, 2, 3, 4};
  EXPECT_DOUBLE_EQ(sorted_quantile(sorted, 0), 1);
  EXPECT_DOUBLE_EQ(sorted_quantile(sorted, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(sorted_quantile(sorted, 1), 4);
}

TEST(Intervals, AQuantileOfValuesInAnyOrderIsThatOfTheSortedOnes) {
  for (const std::size_t count : {1, 2, 7, 1000}) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<double>(i * 7919 % 31) / 3;
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    for (const double q : {0.0, 0.025, 0.5, 0.975, 1.0})
      EXPECT_EQ(quantile(values, q), sorted_quantile(sorted, q)) << count << ", " << q;
  }
}

}  // namespace
}  // namespace facet
