#include "surface/shallow_basins.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/clones.hpp"

namespace facet {
namespace {

/// Step of depth across a contact, over the largest one within a surface: what is tolerated, noise, or a step
/// of the fixed point.
double step_at(const BasinLandscape& l, int place, const ShallowLimits& limits) {
  const int x = place / 2 % l.basin.width, y = place / 2 / l.basin.width;
  const bool down = place % 2 != 0;
  const double here = l.q(x, y), there = down ? l.q(x, y + 1) : l.q(x + 1, y);
  const double noise = double{limits.noise.sigma_m(static_cast<float>(1 / here))} * here;
  const double most = std::max({limits.step_ratio, limits.step_sigmas * noise, l.inverse_depth_unit / here});
  return std::abs(here - there) / (here * most);
}

/// Names to numbers, as vectors.
FACET_CPU_CLONES void number_row(const std::int32_t* name, const std::int32_t* number, int width,
                                 std::int32_t* region) {
#pragma GCC ivdep
  for (int x = 0; x < width; ++x) {
    const std::int32_t of_name = number[std::max(name[x], 0)];
    region[x] = name[x] < 0 ? -1 : of_name;
  }
}

}  // namespace

/// A basin is named by one of its own pixels.
void ShallowBasins::number_basins(const BasinLandscape& l, ImageView<std::int32_t> region) {
  number_.resize(static_cast<std::size_t>(region.size().area()));
  int count = 0;
  for (int y = 0; y < region.height; ++y) {
    const std::int32_t* name = l.basin.row(y);
    for (int x = 0, i = y * region.width; x < region.width; ++x, ++i)
      if (name[x] == i) number_[static_cast<std::size_t>(i)] = count++;
  }
  for (int y = 0; y < region.height; ++y)
    number_row(l.basin.row(y), number_.data(), region.width, region.row(y));
  measure_basins(l, region, count);
}

/// Neighbours are mostly of one basin, whose sums would have to wait for each other: pixels of distant rows
/// take turns. What is in no basin is counted before the first one.
void ShallowBasins::measure_basins(const BasinLandscape& l, ImageView<const std::int32_t> region, int count) {
  constexpr int turns = 4;
  basins_.assign(static_cast<std::size_t>(count) + 1, {0, unknown_strength});
  Basin* const first = basins_.data() + 1;
  const int rows = (region.height + turns - 1) / turns;
  const auto add = [&](int x, int y) {
    Basin& basin = first[region(x, y)];
    ++basin.count_px;
    basin.bottom = std::min(basin.bottom, l.strength(x, y));
  };
  for (int y = 0; y < rows; ++y) {
    const int used = (region.height - y + rows - 1) / rows;
    for (int x = 0; x < region.width; ++x)
      for (int k = 0; k < used; ++k) add(x, y + k * rows);
  }
  basins_.erase(basins_.begin());
}

bool ShallowBasins::is_shallow(const Pass& pass, const Basin& a, const Basin& b) const {
  return std::min(a.count_px, b.count_px) <= limits_.most_px &&
         pass.height - std::max(a.bottom, b.bottom) < floor_;
}

bool ShallowBasins::are_blind(const Basin& a, const Basin& b) const {
  return std::min(a.bottom, b.bottom) >= unknown_strength && a.count_px + b.count_px <= limits_.most_blind_px;
}

bool ShallowBasins::may_join(const Pass& pass) const {
  const Basin &a = basin(pass.a), &b = basin(pass.b);
  return pass.height < unknown_strength ? is_shallow(pass, a, b) : are_blind(a, b);
}

/// Those between basins that may be joined, lowest first. Joined basins are larger and their bottom is no
/// higher, so that the others cannot become candidates later.
void ShallowBasins::collect_passes(const BasinLandscape& l, std::span<const BasinContact> contacts) {
  passes_.clear();
  for (const auto& [a, b, place, strength] : contacts) {
    Pass pass{strength, a, b};
    if (!may_join(pass)) continue;
    const double step = step_at(l, place, limits_);
    if (step > 1) continue;
    if (strength >= unknown_strength) pass.height += static_cast<float>(step);
    passes_.push_back(pass);
  }
  constexpr float levels_per_chord = 4096;  // a hundredth of a degree
  constexpr int levels = static_cast<int>(levels_per_chord * (unknown_strength + 1)) + 1;
  sort_(passes_, levels, [](const Pass& pass) { return static_cast<int>(levels_per_chord * pass.height); });
}

void ShallowBasins::join_passes() {
  sets_.reset(static_cast<int>(basins_.size()));
  for (const Pass& pass : passes_) {
    const int a = sets_.find(pass.a), b = sets_.find(pass.b);
    if (a == b || !may_join({pass.height, a, b})) continue;
    sets_.join(a, b);
    basin(sets_.find(a)) = {basin(a).count_px + basin(b).count_px,
                            std::min(basin(a).bottom, basin(b).bottom)};
  }
}

int ShallowBasins::number_regions(ImageView<std::int32_t> region) {
  number_.resize(basins_.size());
  int count = 0;
  for (int i = 0; i < static_cast<int>(basins_.size()); ++i) {
    const int first = sets_.find(i);
    number_[static_cast<std::size_t>(i)] = first == i ? count++ : number_[static_cast<std::size_t>(first)];
  }
  for (int y = 0; y < region.height; ++y)
    for (int x = 0; x < region.width; ++x)
      if (region(x, y) >= 0) region(x, y) = number_[static_cast<std::size_t>(region(x, y))];
  return count;
}

void ShallowBasins::number_contacts(std::vector<BasinContact>& contacts) const {
  std::size_t kept = 0;
  for (const auto& [a, b, place, strength] : contacts) {
    const auto [first, second] =
        std::minmax(number_[static_cast<std::size_t>(a)], number_[static_cast<std::size_t>(b)]);
    if (first != second) contacts[kept++] = {first, second, place, strength};
  }
  contacts.resize(kept);
}

int ShallowBasins::join(const BasinLandscape& landscape, const ShallowLimits& limits,
                        Image<std::int32_t>& region, std::vector<BasinContact>& contacts) {
  limits_ = limits;
  floor_ = landscape.floor;
  region.resize(landscape.basin.size());
  number_basins(landscape, region.view());
  collect_contacts(landscape, std::as_const(region).view(), contacts);
  collect_passes(landscape, contacts);
  join_passes();
  const int count = number_regions(region.view());
  number_contacts(contacts);
  return count;
}

}  // namespace facet
