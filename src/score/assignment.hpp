#pragma once

#include <span>
#include <vector>

namespace facet {

/// What it is worth to give row and column to each other.
struct WeightedPair {
  int row = 0, column = 0;
  double weight = 0;
};

/// The pairs of a one-to-one assignment with the largest total weight, by row. Pairs that are not listed, or
/// weigh nothing, are never chosen. No pair may be listed twice; weights >= 0. Shortest augmenting paths
/// (Jonker and Volgenant 1987) on every connected part of the graph: O(r^2 c) for its smaller side r.
std::vector<WeightedPair> best_assignment(std::span<const WeightedPair> pairs);

}  // namespace facet
