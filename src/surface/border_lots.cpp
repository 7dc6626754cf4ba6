#include "surface/border_lots.hpp"

#include <algorithm>
#include <tuple>

namespace facet {

const std::vector<std::vector<int>>& BorderLots::cast(std::span<const BasinBorder> borders, int basin_count,
                                                      int lot_count) {
  linked_.reset(basin_count);
  for (const BasinBorder& border : borders) linked_.join(border.a, border.b);

  islands_.clear();
  place_.assign(static_cast<std::size_t>(basin_count), -1);
  const auto place_of = [this](const BasinBorder& border) -> int& {
    return place_[static_cast<std::size_t>(linked_.find(border.a))];
  };
  for (const BasinBorder& border : borders) {
    if (place_of(border) < 0) {
      place_of(border) = static_cast<int>(islands_.size());
      islands_.push_back({linked_.find(border.a)});
    }
    ++islands_[static_cast<std::size_t>(place_of(border))].borders;
  }
  std::sort(islands_.begin(), islands_.end(), [](const Island& l, const Island& r) {
    return std::tie(r.borders, l.first_basin) < std::tie(l.borders, r.first_basin);
  });

  loads_.assign(static_cast<std::size_t>(lot_count), 0);
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    const auto least = std::min_element(loads_.begin(), loads_.end());
    *least += islands_[i].borders;
    islands_[i].lot = static_cast<int>(least - loads_.begin());
    place_[static_cast<std::size_t>(islands_[i].first_basin)] = static_cast<int>(i);
  }
  lots_.resize(static_cast<std::size_t>(lot_count));
  for (std::vector<int>& lot : lots_) lot.clear();
  for (std::size_t i = 0; i < borders.size(); ++i) {
    const int lot = islands_[static_cast<std::size_t>(place_of(borders[i]))].lot;
    lots_[static_cast<std::size_t>(lot)].push_back(static_cast<int>(i));
  }
  return lots_;
}

}  // namespace facet
