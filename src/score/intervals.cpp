#include "score/intervals.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/random.hpp"

namespace facet {

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
  std::sort(values.begin(), values.end());
  return Interval{sorted_quantile(values, 0.025), sorted_quantile(values, 0.975)};
}

double sorted_quantile(std::span<const double> sorted, double q) {
  const double position = q * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (position - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace facet
