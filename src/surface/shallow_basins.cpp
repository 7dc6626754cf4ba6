#include "surface/shallow_basins.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/clones.hpp"
#include "core/sparse_row.hpp"
#include "surface/renumber.hpp"

namespace facet {
namespace {

/// Step of inverse depth across a contact, and the largest one within a surface: what is tolerated, noise, or
/// a step of the fixed point.
struct Step {
  double size, most;
};
Step step_at(const BasinLandscape& l, int place, const ShallowLimits& limits) {
  const int x = place / 2 % l.basin.width, y = place / 2 / l.basin.width;
  const bool down = place % 2 != 0;
  const double here = l.q(x, y), there = down ? l.q(x, y + 1) : l.q(x + 1, y);
  const double noise = double{limits.noise.sigma_m(static_cast<float>(1 / here))} * here;
  return {std::abs(here - there),
          std::max(here * std::max(limits.step_ratio, limits.step_sigmas * noise), l.inverse_depth_unit)};
}

/// 1 where a basin is named by the pixel itself.
FACET_CPU_CLONES void mark_names(const std::int32_t* name, int first, int width, std::uint8_t* is_name) {
  for (int x = 0; x < width; ++x) is_name[x] = name[x] == first + x;
}

/// All lists of the parts in a row, in `all`; the first part's is empty then.
template <class Part, class T>
void gather(std::vector<Part>& parts, std::vector<T> Part::*list, std::vector<T>& all) {
  all.clear();
  all.swap(parts.front().*list);
  for (std::size_t i = 1; i < parts.size(); ++i)
    all.insert(all.end(), (parts[i].*list).begin(), (parts[i].*list).end());
}

}  // namespace

template <class Work>
void ShallowBasins::for_each_part(HostThreads& threads, const Work& work) {
  threads.share_out(static_cast<int>(parts_.size()),
                    [&](int i, int) { work(parts_[static_cast<std::size_t>(i)]); });
}

void ShallowBasins::lay_out_parts(int height, int count) {
  parts_.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    parts_[static_cast<std::size_t>(i)].begin_y = height * i / count;
    parts_[static_cast<std::size_t>(i)].end_y = height * (i + 1) / count;
  }
}

/// A basin is named by one of its own pixels.
int ShallowBasins::number_basins(HostThreads& threads, const BasinLandscape& l,
                                 ImageView<std::int32_t> region) {
  number_.resize(static_cast<std::size_t>(region.size().area()));
  is_name_.resize(static_cast<std::size_t>(region.width));
  int count = 0;
  for (int y = 0; y < region.height; ++y) {
    const int first = y * region.width;
    mark_names(l.basin.row(y), first, region.width, is_name_.data());
    for_each_set_in_row(is_name_.data(), region.width,
                        [&](int x) { number_[static_cast<std::size_t>(first + x)] = count++; });
  }
  renumber(threads, l.basin, number_, region);
  return count;
}

/// Neighbours are mostly of one basin, whose sums would have to wait for each other: pixels of distant rows
/// take turns. What is in no basin is counted before the first one.
void ShallowBasins::measure_basins(const BasinLandscape& l, ImageView<const std::int32_t> region, int count,
                                   Part& part) const {
  constexpr int turns = 4;
  part.basins.assign(static_cast<std::size_t>(count) + 1, {0, unknown_strength});
  Basin* const first = part.basins.data() + 1;
  const int rows = (part.end_y - part.begin_y + turns - 1) / turns;
  const auto add = [&](int x, int y) {
    Basin& basin = first[region(x, y)];
    ++basin.count_px;
    basin.bottom = std::min(basin.bottom, l.strength(x, y));
  };
  for (int y = part.begin_y; y < part.begin_y + rows; ++y) {
    const int used = (part.end_y - y + rows - 1) / rows;
    for (int x = 0; x < region.width; ++x)
      for (int k = 0; k < used; ++k) add(x, y + k * rows);
  }
  part.basins.erase(part.basins.begin());
}

void ShallowBasins::add_up_basins() {
  basins_.swap(parts_.front().basins);
  for (std::size_t k = 1; k < parts_.size(); ++k)
    for (std::size_t i = 0; i < basins_.size(); ++i) {
      const Basin& more = parts_[k].basins[i];
      basins_[i] = {basins_[i].count_px + more.count_px, std::min(basins_[i].bottom, more.bottom)};
    }
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

/// Those between basins that may be joined. Joined basins are larger and their bottom is no higher, so that
/// the others cannot become candidates later.
void ShallowBasins::collect_passes(const BasinLandscape& l, Part& part) const {
  part.passes.clear();
  for (const auto& [a, b, place, strength] : part.contacts) {
    Pass pass{strength, a, b};
    if (!may_join(pass)) continue;
    const Step step = step_at(l, place, limits_);
    if (step.size > step.most) continue;
    if (strength >= unknown_strength) pass.height += static_cast<float>(step.size / step.most);
    part.passes.push_back(pass);
  }
}

void ShallowBasins::sort_passes() {
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

/// Numbers by basin.
int ShallowBasins::number_regions() {
  number_.resize(basins_.size());
  int count = 0;
  for (int i = 0; i < static_cast<int>(basins_.size()); ++i) {
    const int first = sets_.find(i);
    number_[static_cast<std::size_t>(i)] = first == i ? count++ : number_[static_cast<std::size_t>(first)];
  }
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

int ShallowBasins::join(HostThreads& threads, const BasinLandscape& landscape, const ShallowLimits& limits,
                        Image<std::int32_t>& region, std::vector<BasinContact>& contacts) {
  limits_ = limits;
  floor_ = landscape.floor;
  region.resize(landscape.basin.size());
  const ImageView<const std::int32_t> numbers = std::as_const(region).view();
  lay_out_parts(region.height(), threads.workers());
  const int basins = number_basins(threads, landscape, region.view());
  for_each_part(threads, [&](Part& part) { measure_basins(landscape, numbers, basins, part); });
  add_up_basins();
  for_each_part(threads, [&](Part& part) {
    collect_contacts(landscape, numbers, part.begin_y, part.end_y, part.contacts);
    collect_passes(landscape, part);
  });
  gather(parts_, &Part::passes, passes_);
  sort_passes();
  join_passes();
  const int count = number_regions();
  renumber(threads, numbers, number_, region.view());
  for_each_part(threads, [&](Part& part) { number_contacts(part.contacts); });
  gather(parts_, &Part::contacts, contacts);
  return count;
}

}  // namespace facet
