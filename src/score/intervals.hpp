#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace facet {

/// A 95 % interval.
struct Interval {
  double lo = 0, hi = 0;
};

/// Wilson 1927 for `hit` of `n` independent trials; n > 0.
Interval wilson_interval(double hit, double n);

struct BootstrapOptions {
  int replicates = 10000;
  std::uint64_t seed = 1;
};

/// Calls `visit` with the indices of the frames of every replicate. `sequences` names the sequence of each
/// frame, "" = a frame by itself: sequences are drawn with replacement, and so are the frames of each drawn
/// one. Depends on nothing but the arguments.
void for_each_resample(const std::vector<std::string>& sequences, const BootstrapOptions& options,
                       const std::function<void(const std::vector<int>& frames)>& visit);

/// Interval between the 2.5 % and 97.5 % quantiles (linear between order statistics); nothing for no values.
std::optional<Interval> percentile_interval(std::vector<double> values);
/// Quantile q in [0, 1] of sorted values. Needs at least one value.
double sorted_quantile(std::span<const double> sorted, double q);
/// The same of values in any order, which it changes.
double quantile(std::span<double> values, double q);

}  // namespace facet
