#include "surface/basin_graph.hpp"

#include <algorithm>
#include <tuple>

#include "core/run.hpp"

namespace facet {
namespace {

/// A border known along fewer pairs than this says nothing.
constexpr int min_known_pairs = 3;

/// Joins borders between the same two regions; their points stay evenly spread.
BasinBorder united(std::span<const BasinBorder> parts) {
  BasinBorder whole = parts[0];
  for (const BasinBorder& part : parts.subspan(1)) {
    whole.length += part.length;
    whole.known += part.known;
    whole.sum += part.sum;
    whole.lowest = std::min(whole.lowest, part.lowest);
  }
  constexpr auto most = static_cast<int>(BasinBorder::most_points);
  whole.points = std::min(whole.length, most);
  int part = 0, passed = 0;
  for (int k = 0; k < whole.points; ++k) {
    const int place = (2 * k + 1) * whole.length / (2 * whole.points);
    const auto at = [&]() -> const BasinBorder& { return parts[static_cast<std::size_t>(part)]; };
    while (place >= passed + at().length) passed += at().length, ++part;
    const int own = (place - passed) * at().points / at().length;
    whole.point[static_cast<std::size_t>(k)] = at().point[static_cast<std::size_t>(own)];
  }
  return whole;
}

/// Calls for_group(span) for every run of items between the same two regions.
template <class Item, class ForGroup>
void for_each_group(std::span<const Item> items, const ForGroup& for_group) {
  for (std::size_t begin = 0, end = 0; begin < items.size(); begin = end) {
    while (end < items.size() && items[end].a == items[begin].a && items[end].b == items[begin].b) ++end;
    for_group(items.subspan(begin, end - begin));
  }
}

}  // namespace

float BasinBorder::strength() const {
  return known < min_known_pairs ? unknown_strength : sum / static_cast<float>(known);
}

void BasinGraph::build(const BasinLandscape& landscape) {
  collect_basins(landscape);
  collect_contacts(landscape);
  collect_borders(landscape);
}

void BasinGraph::collect_basins(const BasinLandscape& l) {
  const int width = l.basin.width, height = l.basin.height;
  basins_.clear();
  index_.assign(static_cast<std::size_t>(l.basin.size().area()), -1);
  for (int y = 0; y < height; ++y)
    for (int begin = 0, end = 0; begin < width; begin = end) {
      const std::int32_t name = l.basin(begin, y);
      end = end_of_run(l.basin.row(y), begin + 1, width, name);
      if (name < 0) continue;
      std::int32_t& index = index_[static_cast<std::size_t>(name)];
      if (index < 0) {
        index = static_cast<std::int32_t>(basins_.size());
        basins_.push_back({index, name, unknown_strength, {}});
      }
      Basin& basin = basins_[static_cast<std::size_t>(index)];
      const std::int32_t* q = l.inverse_depth.row(y) + begin;
      basin.moments.add_run(begin - static_cast<double>(l.camera.cx), y - static_cast<double>(l.camera.cy),
                            end - begin, [&](int k) { return l.inverse_depth_unit * q[k]; });
      for (int x = begin; x < end; ++x)
        if (l.distance_px(x, y) > l.guard_px) basin.lowest = std::min(basin.lowest, l.strength(x, y));
    }
}

void BasinGraph::collect_contacts(const BasinLandscape& l) {
  contacts_.clear();
  const auto add_pair = [&](int x0, int y0, int x1, int y1) {
    const std::int32_t here = l.basin(x0, y0), there = l.basin(x1, y1);
    if (here == there || here < 0 || there < 0) return;
    const int a = index_[static_cast<std::size_t>(here)], b = index_[static_cast<std::size_t>(there)];
    const bool known = l.distance_px(x0, y0) > l.guard_px && l.distance_px(x1, y1) > l.guard_px;
    const float strength = known ? std::max(l.strength(x0, y0), l.strength(x1, y1)) : unknown_strength;
    contacts_.push_back(
        {std::min(a, b), std::max(a, b), 2 * (y0 * l.basin.width + x0) + (y1 > y0), strength});
  };
  for (int y = 0; y < l.basin.height; ++y)
    for (int x = 0; x < l.basin.width; ++x) {
      if (x + 1 < l.basin.width) add_pair(x, y, x + 1, y);
      if (y + 1 < l.basin.height) add_pair(x, y, x, y + 1);
    }
  std::sort(contacts_.begin(), contacts_.end(), [](const Contact& l_, const Contact& r) {
    return std::tie(l_.a, l_.b, l_.place) < std::tie(r.a, r.b, r.place);
  });
}

/// A border from its contacts, in order.
BasinBorder BasinGraph::border_of(const BasinLandscape& l, std::span<const Contact> contacts) {
  BasinBorder border{contacts[0].a, contacts[0].b, static_cast<int>(contacts.size())};
  for (const Contact& c : contacts) {
    border.lowest = std::min(border.lowest, c.strength);
    if (c.strength < unknown_strength) border.sum += c.strength, ++border.known;
  }
  border.points = std::min(border.length, static_cast<int>(BasinBorder::most_points));
  for (int k = 0; k < border.points; ++k) {
    const auto& c = contacts[static_cast<std::size_t>((2 * k + 1) * border.length / (2 * border.points))];
    const int x = c.place / 2 % l.basin.width, y = c.place / 2 / l.basin.width;
    const bool down = c.place % 2 != 0;
    border.point[static_cast<std::size_t>(k)] = {static_cast<float>(x) + (down ? 0.0f : 0.5f) - l.camera.cx,
                                                 static_cast<float>(y) + (down ? 0.5f : 0.0f) - l.camera.cy};
  }
  return border;
}

void BasinGraph::collect_borders(const BasinLandscape& landscape) {
  borders_.clear();
  for_each_group(std::span<const Contact>(contacts_),
                 [&](std::span<const Contact> group) { borders_.push_back(border_of(landscape, group)); });
}

int BasinGraph::find(int i) {
  auto parent = [&](int k) -> int& { return basins_[static_cast<std::size_t>(k)].parent; };
  while (parent(i) != i) i = parent(i) = parent(parent(i));
  return i;
}

void BasinGraph::join(int a, int b) {
  Basin &into = basin(a), &from = basin(b);
  from.parent = a;
  into.name = std::min(into.name, from.name);
  into.lowest = std::min(into.lowest, from.lowest);
  into.moments += from.moments;
}

void BasinGraph::update_borders() {
  order_.clear();
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    const int a = find(borders_[i].a), b = find(borders_[i].b);
    if (a != b) order_.push_back({std::min(a, b), std::max(a, b), static_cast<int>(i)});
  }
  std::sort(order_.begin(), order_.end(), [](const Place& l, const Place& r) {
    return std::tie(l.a, l.b, l.index) < std::tie(r.a, r.b, r.index);
  });
  joined_.clear();
  for_each_group(std::span<const Place>(order_), [&](std::span<const Place> group) {
    parts_.clear();
    for (const Place& place : group) parts_.push_back(borders_[static_cast<std::size_t>(place.index)]);
    joined_.push_back(united(parts_));
    joined_.back().a = group[0].a, joined_.back().b = group[0].b;
  });
  borders_.swap(joined_);
}

void BasinGraph::write_regions(const BasinLandscape& l, ImageView<std::int32_t> region) {
  for (int y = 0; y < l.basin.height; ++y)
    for (int x = 0; x < l.basin.width; ++x) {
      const std::int32_t name = l.basin(x, y);
      region(x, y) = name < 0 ? -1 : basin(find(index_[static_cast<std::size_t>(name)])).name;
    }
}

}  // namespace facet
