#include "surface/basin_graph.hpp"

#include <algorithm>

#include "core/clones.hpp"
#include "core/run.hpp"

namespace facet {
namespace {

/// A border known along fewer pairs than this says nothing.
constexpr int min_known_pairs = 3;

/// Adds another border between the same two regions; the points stay evenly spread.
void extend(BasinBorder& border, const BasinBorder& other) {
  const BasinBorder before = border;
  border.length += other.length;
  border.known += other.known;
  border.sum += other.sum;
  border.seam.count = 0;
  const int points = std::min(border.length, Seam::most_points);
  for (int k = 0; k < points; ++k) {
    const int place = (2 * k + 1) * border.length / (2 * points);
    const bool is_first = place < before.length;
    const BasinBorder& part = is_first ? before : other;
    const auto own =
        static_cast<std::size_t>((place - (is_first ? 0 : before.length)) * part.seam.count / part.length);
    border.seam.add(part.seam.x[own], part.seam.y[own]);
  }
}

}  // namespace

float BasinBorder::strength() const {
  return known < min_known_pairs ? unknown_strength : sum / static_cast<float>(known);
}

void BasinGraph::build(HostThreads& threads, const BasinLandscape& landscape,
                       ImageView<const std::int32_t> basin, int count, std::vector<BasinContact>& contacts) {
  collect_moments(threads, landscape, basin, count);
  sets_.reset(count);
  sort_(contacts, count, [](const BasinContact& c) { return c.b; });
  sort_(contacts, count, [](const BasinContact& c) { return c.a; });
  collect_borders(threads, landscape, contacts);
  list_borders();
}

FACET_CPU_CLONES void BasinGraph::collect_moments(const BasinLandscape& l,
                                                  ImageView<const std::int32_t> basin, int begin_y, int end_y,
                                                  std::vector<PatchMoments>& moments) {
  for (int y = begin_y; y < end_y; ++y)
    for (int begin = 0, end = 0; begin < basin.width; begin = end) {
      const std::int32_t number = basin(begin, y);
      end = end_of_run(basin.row(y), begin + 1, basin.width, number);
      if (number < 0) continue;
      const std::int32_t* q = l.inverse_depth.row(y) + begin;
      moments[static_cast<std::size_t>(number)].add_run(begin - static_cast<double>(l.camera.cx),
                                                        y - static_cast<double>(l.camera.cy), end - begin,
                                                        [&](int k) { return l.inverse_depth_unit * q[k]; });
    }
}

/// Two halves of the image, for any number of threads, on which sums must not depend.
void BasinGraph::collect_moments(HostThreads& threads, const BasinLandscape& l,
                                 ImageView<const std::int32_t> basin, int count) {
  threads.share_out(2, [&](int half, int) {
    std::vector<PatchMoments>& moments = half == 0 ? moments_ : lower_moments_;
    moments.assign(static_cast<std::size_t>(count), {});
    collect_moments(l, basin, half * basin.height / 2, (half + 1) * basin.height / 2, moments);
  });
  for (std::size_t i = 0; i < moments_.size(); ++i)
    if (lower_moments_[i].count() > 0) moments_[i] += lower_moments_[i];
}

/// A border from its contacts, in order.
BasinBorder BasinGraph::border_of(const BasinLandscape& l, std::span<const BasinContact> contacts) {
  BasinBorder border{contacts[0].a, contacts[0].b, static_cast<int>(contacts.size())};
  for (const BasinContact& c : contacts)
    if (c.strength < unknown_strength) border.sum += c.strength, ++border.known;
  const int points = std::min(border.length, Seam::most_points);
  for (int k = 0; k < points; ++k) {
    const auto& c = contacts[static_cast<std::size_t>((2 * k + 1) * border.length / (2 * points))];
    const int x = c.place / 2 % l.basin.width, y = c.place / 2 / l.basin.width;
    const bool down = c.place % 2 != 0;
    border.seam.add(static_cast<float>(x) + (down ? 0.0f : 0.5f) - l.camera.cx,
                    static_cast<float>(y) + (down ? 0.5f : 0.0f) - l.camera.cy);
  }
  return border;
}

void BasinGraph::collect_borders(HostThreads& threads, const BasinLandscape& landscape,
                                 std::span<const BasinContact> all) {
  begins_.clear();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i == 0 || all[i].a != all[i - 1].a || all[i].b != all[i - 1].b) begins_.push_back(i);
  borders_.resize(begins_.size());
  begins_.push_back(all.size());
  constexpr std::size_t least_borders = 512;  // a tenth of a millisecond
  threads.for_each_part(borders_.size(), least_borders, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      borders_[i] = border_of(landscape, all.subspan(begins_[i], begins_[i + 1] - begins_[i]));
  });
}

void BasinGraph::list_borders() {
  first_.assign(moments_.size(), -1);
  last_.assign(moments_.size(), -1);
  degree_.assign(moments_.size(), 0);
  next_.assign(2 * borders_.size(), -1);
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    const auto append = [this](int region, int side) {
      int& last = last_[static_cast<std::size_t>(region)];
      (last < 0 ? first_[static_cast<std::size_t>(region)] : next_[static_cast<std::size_t>(last)]) = side;
      last = side;
      ++degree_[static_cast<std::size_t>(region)];
    };
    append(borders_[i].a, static_cast<int>(2 * i));
    append(borders_[i].b, static_cast<int>(2 * i + 1));
  }
}

int BasinGraph::neighbour_across(int border_index, int region) {
  const int a = find(border(border_index).a);
  return a == region ? find(border(border_index).b) : a;
}

/// The border between two regions, -1 = none.
int BasinGraph::border_between(int a, int b) {
  if (degree_[static_cast<std::size_t>(a)] > degree_[static_cast<std::size_t>(b)]) std::swap(a, b);
  int found = -1;
  for_each_border_of(a, [&](int i) {
    if (neighbour_across(i, a) == b) found = i;
  });
  return found;
}

void BasinGraph::join(int a, int b, std::vector<int>& touched) {
  if (b < a) std::swap(a, b);
  const auto of = [](std::vector<int>& values, int k) -> int& { return values[static_cast<std::size_t>(k)]; };
  // A large region has hundreds of borders: only those of the other one are visited.
  const int fewer = of(degree_, a) < of(degree_, b) ? a : b, more = fewer == a ? b : a;
  touched.clear();
  for_each_border_of(fewer, [&](int i) {
    const int neighbour = neighbour_across(i, fewer);
    const int other = neighbour == more ? -1 : border_between(neighbour, more);
    if (other >= 0) extend(border(other), border(i));
    if (neighbour == more || other >= 0) border(i).length = 0;
    if (neighbour != more) touched.push_back(other >= 0 ? other : i);
  });
  (of(last_, more) < 0 ? of(first_, more) : of(next_, of(last_, more))) = of(first_, fewer);
  if (of(last_, fewer) >= 0) of(last_, more) = of(last_, fewer);
  of(first_, a) = of(first_, more), of(last_, a) = of(last_, more);
  of(degree_, a) += of(degree_, b);
  sets_.join(a, b);
  moments_[static_cast<std::size_t>(a)] += moments_[static_cast<std::size_t>(b)];
}

}  // namespace facet
