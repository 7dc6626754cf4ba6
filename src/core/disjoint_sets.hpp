#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace facet {

/// Union-find over 0 ... n - 1. A set is named by its smallest member. Keeps its memory.
class DisjointSets {
 public:
  /// Every one of `count` a set of its own.
  void reset(int count) {
    parent_.resize(static_cast<std::size_t>(count));
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int i) {
    const auto parent = [this](int k) -> int& { return parent_[static_cast<std::size_t>(k)]; };
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }
  void join(int a, int b) {
    a = find(a), b = find(b);
    parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

}  // namespace facet
