#include "score/assignment.hpp"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <numeric>
#include <set>

#include "core/random.hpp"

namespace facet {
namespace {

using Matrix = std::vector<std::vector<double>>;

/// The assignment, after checking that it is one to one and made of listed pairs.
double checked_total(const Matrix& weights) {
  std::vector<WeightedPair> pairs;
  for (int r = 0; r < static_cast<int>(weights.size()); ++r)
    for (int c = 0; c < static_cast<int>(weights[0].size()); ++c)
      pairs.push_back({r, c, weights[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)]});
  double total = 0;
  std::set<int> rows, columns;
  for (const WeightedPair& p : best_assignment(pairs)) {
    EXPECT_TRUE(rows.insert(p.row).second && columns.insert(p.column).second);
    EXPECT_GT(p.weight, 0);
    EXPECT_EQ(p.weight, weights[static_cast<std::size_t>(p.row)][static_cast<std::size_t>(p.column)]);
    total += p.weight;
  }
  return total;
}

/// Tries every order of the columns; rows <= columns.
double brute_force_total(const Matrix& weights) {
  std::vector<std::size_t> columns(weights[0].size());
  std::iota(columns.begin(), columns.end(), 0u);
  double best = 0;
  do {
    double total = 0;
    for (std::size_t r = 0; r < weights.size(); ++r) total += weights[r][columns[r]];
    best = std::max(best, total);
  } while (std::next_permutation(columns.begin(), columns.end()));
  return best;
}

TEST(Assignment, HasTheTotalOfTheBestOfAllPermutations) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const std::size_t rows = 1 + seed % 5, columns = rows + seed % 3;
    const float density = seed % 4 == 0 ? 1.0f : 0.4f;
    Matrix weights(rows, std::vector<double>(columns));
    std::uint64_t i = 0;
    for (auto& row : weights)
      for (double& w : row) {
        w = random_uniform(seed, 1, i) < density ? random_below(8, seed, 2, i) / 8.0 : 0;  // with ties
        ++i;
      }
    EXPECT_NEAR(checked_total(weights), brute_force_total(weights), 1e-12) << "seed " << seed;
  }
}

TEST(Assignment, HasTheTotalThatScipyFinds) {
  std::ifstream file(FACET_SCORE_FIXTURES "/assignment_fixture.txt");
  std::size_t rows = 0, columns = 0;
  double total = 0;
  int cases = 0;
  while (file >> rows >> columns >> total) {
    Matrix weights(rows, std::vector<double>(columns));
    for (auto& row : weights)
      for (double& w : row) ASSERT_TRUE(file >> w);
    EXPECT_NEAR(checked_total(weights), total, 1e-9) << rows << "x" << columns;
    ++cases;
  }
  EXPECT_EQ(cases, 10);
}

TEST(Assignment, TakesTwoGoodPairsRatherThanTheBestOne) {
  const auto given = best_assignment(std::vector<WeightedPair>{{4, 7, 1.0}, {4, 9, 0.9}, {5, 7, 0.8}});
  ASSERT_EQ(given.size(), 2u);
  EXPECT_EQ(given[0].column, 9);
  EXPECT_EQ(given[1].column, 7);
}

TEST(Assignment, OfNothingIsEmpty) {
  EXPECT_TRUE(best_assignment({}).empty());
  EXPECT_TRUE(best_assignment(std::vector<WeightedPair>{{0, 0, 0.0}}).empty());
}

}  // namespace
}  // namespace facet
