#include "surface/shallow_basins.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/run.hpp"

namespace facet {

void ShallowBasins::number_basins(const BasinLandscape& l, ImageView<std::int32_t> region) {
  basins_.clear();
  number_.assign(static_cast<std::size_t>(region.size().area()), -1);
  for (int y = 0; y < region.height; ++y)
    for (int begin = 0, end = 0; begin < region.width; begin = end) {
      const std::int32_t name = l.basin(begin, y);
      end = end_of_run(l.basin.row(y), begin + 1, region.width, name);
      std::fill(region.row(y) + begin, region.row(y) + end, -1);
      if (name < 0) continue;
      std::int32_t& number = number_[static_cast<std::size_t>(name)];
      if (number < 0) {
        number = static_cast<std::int32_t>(basins_.size());
        basins_.emplace_back();
      }
      std::fill(region.row(y) + begin, region.row(y) + end, number);
      float lowest = basin(number).lowest;
      for (int x = begin; x < end; ++x) lowest = std::min(lowest, l.known_strength(x, y));
      basin(number) = {basin(number).count_px + end - begin, lowest};
    }
}

bool ShallowBasins::is_shallow(const Pass& pass, const Basin& a, const Basin& b) const {
  return std::min(a.count_px, b.count_px) <= most_px_ && pass.height - std::max(a.lowest, b.lowest) < floor_;
}

/// Those between basins that may be joined. Joined basins are larger and their bottom is no higher, so that
/// the others cannot become candidates later.
void ShallowBasins::collect_passes(const BasinLandscape& l, ImageView<const std::int32_t> region) {
  passes_.clear();
  for_each_contact(l, region, [this](int a, int b, int, int, bool, float strength) {
    const Pass pass{strength, std::min(a, b), std::max(a, b)};
    if (strength < unknown_strength && is_shallow(pass, basin(a), basin(b))) passes_.push_back(pass);
  });
  // The bits of floats that are not negative sort as the floats do.
  order_.resize(passes_.size());
  for (std::size_t i = 0; i < passes_.size(); ++i)
    order_[i] = std::uint64_t{std::bit_cast<std::uint32_t>(passes_[i].height)} << 32 | i;
  std::sort(order_.begin(), order_.end());
}

void ShallowBasins::join_passes() {
  sets_.reset(static_cast<int>(basins_.size()));
  for (const std::uint64_t key : order_) {
    const Pass& pass = passes_[key & 0xffffffff];
    const int a = sets_.find(pass.a), b = sets_.find(pass.b);
    if (a == b || !is_shallow(pass, basin(a), basin(b))) continue;
    sets_.join(a, b);
    basin(sets_.find(a)) = {basin(a).count_px + basin(b).count_px,
                            std::min(basin(a).lowest, basin(b).lowest)};
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

int ShallowBasins::join(const BasinLandscape& landscape, double most_px, Image<std::int32_t>& region) {
  most_px_ = most_px;
  floor_ = landscape.floor;
  region.resize(landscape.basin.size());
  number_basins(landscape, region.view());
  collect_passes(landscape, std::as_const(region).view());
  join_passes();
  return number_regions(region.view());
}

}  // namespace facet
