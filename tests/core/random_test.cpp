#include "core/random.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace facet {
namespace {

// First outputs of the reference SplitMix64 started at 1234567; its state grows by the golden gamma each
// step.
TEST(MixBits, IsSplitMix64) {
  constexpr std::uint64_t gamma = 0x9E3779B97F4A7C15ull;
  EXPECT_EQ(mix_bits(1234567), 6457827717110365317ull);
  EXPECT_EQ(mix_bits(1234567 + gamma), 3203168211198807973ull);
  EXPECT_EQ(mix_bits(1234567 + 2 * gamma), 9817491932198370423ull);
}

/// Chi-square statistic of 64 equal bins over 64000 draws; its mean is 63, its 99.99 % quantile 111.
template <class Draw>
double chi_square(const Draw& draw) {
  std::array<int, 64> bins{};
  for (std::uint64_t i = 0; i < 64000; ++i) ++bins[static_cast<std::size_t>(draw(i))];
  double sum = 0;
  for (const int n : bins) sum += (n - 1000.0) * (n - 1000.0) / 1000.0;
  return sum;
}

TEST(RandomUniform, FillsTheUnitIntervalEvenlyAlongEveryCounter) {
  const auto bin = [](float u) { return static_cast<int>(64 * u); };
  EXPECT_LT(chi_square([&](std::uint64_t i) { return bin(random_uniform(1, 2, i)); }), 111);
  EXPECT_LT(chi_square([&](std::uint64_t i) { return bin(random_uniform(1, i, 2)); }), 111);
  EXPECT_LT(chi_square([&](std::uint64_t i) { return bin(random_uniform(i, 1, 2)); }), 111);
}

TEST(RandomUniform, StaysBelowOne) {
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const float u = random_uniform(3, 4, i);
    EXPECT_TRUE(u >= 0 && u < 1);
  }
}

TEST(RandomUniform, HasNoCorrelationBetweenNeighbouringCounters) {
  double next = 0, stream = 0, seed = 0;
  const int n = 100000;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double u = static_cast<double>(random_uniform(5, 6, i)) - 0.5;
    next += u * (static_cast<double>(random_uniform(5, 6, i + 1)) - 0.5);
    stream += u * (static_cast<double>(random_uniform(5, 7, i)) - 0.5);
    seed += u * (static_cast<double>(random_uniform(6, 6, i)) - 0.5);
  }
  const double four_sigmas = 4 * std::sqrt(static_cast<double>(n)) / 12;
  EXPECT_LT(std::abs(next), four_sigmas);
  EXPECT_LT(std::abs(stream), four_sigmas);
  EXPECT_LT(std::abs(seed), four_sigmas);
}

TEST(RandomBelow, DrawsEveryIntegerBelowTheBoundEquallyOften) {
  EXPECT_LT(chi_square([](std::uint64_t i) { return random_below(64, 8, 9, i); }), 111);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    EXPECT_LT(random_below(3, 1, 1, i), 3u);
    EXPECT_EQ(random_below(1, 1, 1, i), 0u);
  }
}

TEST(RandomBits, DependOnNothingButTheirThreeCounters) {
  EXPECT_EQ(random_bits(1, 2, 3), random_bits(1, 2, 3));
  EXPECT_NE(random_bits(1, 2, 3), random_bits(1, 3, 2));
  EXPECT_NE(random_bits(1, 2, 3), random_bits(2, 1, 3));
}

}  // namespace
}  // namespace facet
