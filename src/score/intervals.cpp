#include "score/intervals.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/random.hpp"

namespace facet {
namespace {

/// Where a quantile lies among sorted values: between two of them.
struct Quantile {
  std::size_t below, above;
  double share;  ///< of the way from one to the other

  Quantile(std::size_t count, double q) {
    const double position = q * static_cast<double>(count - 1);
    below = static_cast<std::size_t>(position);
    above = std::min(below + 1, count - 1);
    share = position - static_cast<double>(below);
  }
  double between(double lower, double upper) const { return lower + share * (upper - lower); }
};

}  // namespace

Interval wilson_interval(double hit, double n) {
  constexpr double z = 1.959963984540054;
  const double share = hit / n, z2 = z * z;
  const double centre = (share + z2 / (2 * n)) / (1 + z2 / n);
  const double half = z / (1 + z2 / n) * std::sqrt(share * (1 - share) / n + z2 / (4 * n * n));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

void for_each_resample(const std::vector<std::string>& sequences, const BootstrapOptions& options,
                       const std::function<void(const std::vector<int>& frames)>& visit) {
  std::vector<std::vector<int>> groups;
  std::map<std::string, std::size_t> group_of;
  for (std::size_t i = 0; i < sequences.size(); ++i) {
    std::size_t group = groups.size();
    if (!sequences[i].empty()) group = group_of.emplace(sequences[i], group).first->second;
    if (group == groups.size()) groups.emplace_back();
    groups[group].push_back(static_cast<int>(i));
  }
  std::vector<int> frames;
  for (int replicate = 0; replicate < options.replicates; ++replicate) {
    frames.clear();
    std::uint64_t index = 0;
    const auto draw = [&](std::size_t n) {
      return random_below(static_cast<std::uint32_t>(n), options.seed, static_cast<std::uint64_t>(replicate),
                          index++);
    };
    for (std::size_t k = 0; k < groups.size(); ++k) {
      const std::vector<int>& group = groups[draw(groups.size())];
      for (std::size_t i = 0; i < group.size(); ++i)
        frames.push_back(group[group.size() > 1 ? draw(group.size()) : 0]);
    }
    visit(frames);
  }
}

std::optional<Interval> percentile_interval(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  return Interval{quantile(values, 0.025), quantile(values, 0.975)};
}

double sorted_quantile(std::span<const double> sorted, double q) {
  const Quantile place(sorted.size(), q);
  return place.between(sorted[place.below], sorted[place.above]);
}

/// Sorts no more than it takes to know the two values that it lies between.
double quantile(std::span<double> values, double q) {
  const Quantile place(values.size(), q);
  const auto below = values.begin() + static_cast<std::ptrdiff_t>(place.below);
  std::nth_element(values.begin(), below, values.end());
  const auto rest = values.begin() + static_cast<std::ptrdiff_t>(place.above);
  return place.between(*below, *std::min_element(rest, values.end()));
}

}  // namespace facet
