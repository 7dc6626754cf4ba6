#include "compare/verdict.hpp"

#include <gtest/gtest.h>

namespace facet {
namespace {

constexpr double alpha = 0.05;

Change change(double before, double after, double lo, double hi, double p) {
  return {before, after, Interval{lo, hi}, p, 100};
}

TEST(Judge, NeedsEffectTestAndIntervalForARegression) {
  const Rule rule{.abs_tolerance = 0.01};
  const auto verdict = [&](const Change& c) { return judge(c, rule, Better::higher, alpha).verdict; };
  EXPECT_EQ(verdict(change(0.9, 0.85, -0.07, -0.03, 0.001)), Verdict::regressed);
  EXPECT_EQ(verdict(change(0.9, 0.895, -0.008, -0.002, 0.001)), Verdict::ok) << "within the tolerance";
  EXPECT_EQ(verdict(change(0.9, 0.85, -0.07, -0.005, 0.001)), Verdict::inconclusive) << "interval";
  EXPECT_EQ(verdict(change(0.9, 0.85, -0.07, -0.03, 0.06)), Verdict::inconclusive) << "p";
}

TEST(Judge, TurnsWithTheDirection) {
  const Change more = change(10, 12, 1.5, 2.5, 0.001);
  EXPECT_EQ(judge(more, {}, Better::lower, alpha).verdict, Verdict::regressed);
  EXPECT_EQ(judge(more, {}, Better::higher, alpha).verdict, Verdict::improved);
  EXPECT_EQ(judge(more, {}, Better::same, alpha).verdict, Verdict::regressed);
  EXPECT_EQ(judge(change(10, 8, -2.5, -1.5, 0.001), {}, Better::same, alpha).verdict, Verdict::regressed);
  EXPECT_EQ(judge(more, {.better = Better::higher}, Better::lower, alpha).verdict, Verdict::improved);
}

TEST(Judge, TakesTheLargerTolerance) {
  const Change slower = change(10, 12, 1.5, 2.5, 0.001);
  EXPECT_EQ(judge(slower, {.abs_tolerance = 0.1, .rel_tolerance = 0.3}, Better::lower, alpha).verdict,
            Verdict::ok);
  EXPECT_EQ(judge(slower, {.abs_tolerance = 3, .rel_tolerance = 0.01}, Better::lower, alpha).verdict,
            Verdict::ok);
}

TEST(Judge, ExactNeedsNoStatistics) {
  const Rule exact{.exact = true};
  const Change worse{0.9, 0.89, std::nullopt, std::nullopt, 100};
  EXPECT_EQ(judge(worse, exact, Better::higher, alpha).verdict, Verdict::regressed);
  EXPECT_EQ(judge({0.9, 0.9, std::nullopt, std::nullopt, 100}, exact, Better::higher, alpha).verdict,
            Verdict::ok);
}

TEST(Judge, SaysNotMeasuredForTooFewSamples) {
  const Judgement few = judge(change(1, 2, 0.5, 1.5, 0.001), {.least_n = 200}, Better::lower, alpha);
  EXPECT_EQ(few.verdict, Verdict::not_measured);
  EXPECT_EQ(few.reason, "n = 100 < 200");
}

}  // namespace
}  // namespace facet
