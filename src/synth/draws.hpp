#pragma once

#include "core/random.hpp"

namespace facet {

/// A sequence of random numbers that depends on (seed, stream) alone.
class Draws {
 public:
  Draws(std::uint64_t seed, std::uint64_t stream) : seed_(seed), stream_(stream) {}

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_uniform(seed_, stream_, next_++));
  }
  /// 0 ... n - 1.
  int below(int n) {
    return static_cast<int>(random_below(static_cast<std::uint32_t>(n), seed_, stream_, next_++));
  }
  bool chance(double share) { return uniform(0, 1) < share; }

 private:
  std::uint64_t seed_, stream_, next_ = 0;
};

}  // namespace facet
