#include "paper/invariance.hpp"

#include <algorithm>
#include <map>

namespace facet {
namespace {

constexpr double allowed_points = 5;

/// Recall of the drawn scenes in points; nothing for nothing to find.
std::optional<double> recall(const std::vector<Tally>& scenes, const std::vector<int>& drawn) {
  double hit = 0, n = 0;
  for (const int i : drawn) {
    const Tally& t = scenes[static_cast<std::size_t>(i) % scenes.size()];
    hit += t.hit;
    n += t.n;
  }
  return n > 0 ? std::optional(100 * hit / n) : std::nullopt;
}

std::vector<int> all_of(std::size_t count) {
  std::vector<int> indices(count);
  for (std::size_t i = 0; i < count; ++i) indices[i] = static_cast<int>(i);
  return indices;
}

}  // namespace

std::optional<LevelDrop> level_drop(const std::vector<FrameRow>& rows, const std::string& dataset,
                                    double nominal, int replicates) {
  std::map<double, std::vector<Tally>> levels;  // scenes in the order of their numbers
  for (const FrameRow& row : rows)
    if (row.dataset == dataset && row.score && row.score->annotated.surfaces)
      levels[row.level].push_back(row.score->surfaces_50.recall());
  if (levels.size() < 2 || !levels.contains(nominal)) return std::nullopt;
  const std::vector<Tally>& reference = levels[nominal];
  const std::size_t count = reference.size();
  LevelDrop drop;
  drop.nominal_level = nominal;
  drop.scenes = static_cast<int>(count);
  double lowest = 1e9;
  for (const auto& [level, scenes] : levels) {
    const auto value = recall(scenes, all_of(scenes.size()));
    if (level == nominal || !value || *value >= lowest || scenes.size() != count) continue;
    lowest = *value;
    drop.worst_level = level;
  }
  const auto at_nominal = recall(reference, all_of(count));
  if (lowest > 100 || !at_nominal) return std::nullopt;
  drop.points = lowest - *at_nominal;
  std::vector<double> differences;
  const std::vector<std::string> alone(count);
  for_each_resample(alone, {.replicates = replicates}, [&](const std::vector<int>& drawn) {
    const auto a = recall(levels[drop.worst_level], drawn), b = recall(reference, drawn);
    if (a && b) differences.push_back(*a - *b);
  });
  if (count > 1) drop.interval = percentile_interval(std::move(differences));
  return drop;
}

bool is_invariant(const LevelDrop& drop) {
  return drop.interval && drop.interval->lo >= -allowed_points && drop.interval->hi <= allowed_points;
}

}  // namespace facet
