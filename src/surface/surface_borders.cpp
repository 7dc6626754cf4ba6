#include "surface/surface_borders.hpp"

#include <algorithm>
#include <cstring>

#include "core/edge_code.hpp"

namespace facet {
namespace {

/// Kinds of the edges within one pixel of (x, y), as bits.
int kinds_around(ImageView<const std::uint8_t> edges, int x, int y) {
  int kinds = 0;
  for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, edges.height - 1); ++ny)
    for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, edges.width - 1); ++nx)
      kinds |= 1 << static_cast<int>(edge_kind_of(edges(nx, ny)));
  return kinds;
}

EdgeKind kind_between(ImageView<const std::uint8_t> edges, int x0, int y0, int x1, int y1) {
  int kinds =
      1 << static_cast<int>(edge_kind_of(edges(x0, y0))) | 1 << static_cast<int>(edge_kind_of(edges(x1, y1)));
  const auto has = [&](EdgeKind kind) { return (kinds & 1 << static_cast<int>(kind)) != 0; };
  if (!has(EdgeKind::depth) && !has(EdgeKind::convex) && !has(EdgeKind::concave))
    kinds = kinds_around(edges, x0, y0) | kinds_around(edges, x1, y1);
  for (const EdgeKind kind : {EdgeKind::depth, EdgeKind::convex, EdgeKind::concave})
    if (has(kind)) return kind;
  return EdgeKind::none;
}

/// visit(x) for every x < count at which two rows differ, from left to right; looks at four at a time.
template <class Visit>
void for_each_difference(const std::uint16_t* a, const std::uint16_t* b, int count, const Visit& visit) {
  constexpr int step = sizeof(std::uint64_t) / sizeof *a;
  int x = 0;
  for (; x + step <= count; x += step) {
    std::uint64_t word_a, word_b;
    std::memcpy(&word_a, a + x, sizeof word_a);
    std::memcpy(&word_b, b + x, sizeof word_b);
    if (word_a == word_b) continue;
    for (int i = x; i < x + step; ++i)
      if (a[i] != b[i]) visit(i);
  }
  for (; x < count; ++x)
    if (a[x] != b[x]) visit(x);
}

}  // namespace

SurfaceBorder& SurfaceBorders::between(int label, int other) {
  const int a = std::min(label, other), b = std::max(label, other);
  int& latest = latest_[static_cast<std::size_t>(a)];
  if (latest >= 0 && borders_[static_cast<std::size_t>(latest)].b == b)
    return borders_[static_cast<std::size_t>(latest)];
  int& first = first_[static_cast<std::size_t>(a)];
  latest = first;
  while (latest >= 0 && borders_[static_cast<std::size_t>(latest)].b != b)
    latest = borders_[static_cast<std::size_t>(latest)].next;
  if (latest < 0) {
    borders_.push_back({.a = a, .b = b, .next = first});
    latest = first = static_cast<int>(borders_.size()) - 1;
  }
  return borders_[static_cast<std::size_t>(latest)];
}

void SurfaceBorders::collect(ImageView<const std::uint16_t> labels, ImageView<const std::uint8_t> edges,
                             int label_count) {
  borders_.clear();
  first_.assign(static_cast<std::size_t>(label_count) + 1, -1);
  latest_.assign(static_cast<std::size_t>(label_count) + 1, -1);
  const auto add_pair = [&](int x0, int y0, int x1, int y1) {
    const int here = labels(x0, y0), there = labels(x1, y1);
    if (here == 0 || there == 0) return;
    SurfaceBorder& border = between(here, there);
    const EdgeKind kind = kind_between(edges, x0, y0, x1, y1);
    border.convex_px += kind == EdgeKind::convex ? 1 : 0;
    border.concave_px += kind == EdgeKind::concave ? 1 : 0;
    if (kind != EdgeKind::depth) return;
    const bool on_here = edge_kind_of(edges(x0, y0)) == kind, on_there = edge_kind_of(edges(x1, y1)) == kind;
    border.depth_px += 1;
    border.a_nearer_px += on_here != on_there && on_here == (here < there) ? 1 : 0;
    border.b_nearer_px += on_here != on_there && on_here != (here < there) ? 1 : 0;
  };
  for (int y = 0; y < labels.height; ++y) {
    const std::uint16_t* row = labels.row(y);
    for_each_difference(row, row + 1, labels.width - 1, [&](int x) { add_pair(x, y, x + 1, y); });
    if (y + 1 == labels.height) break;
    for_each_difference(row, labels.row(y + 1), labels.width, [&](int x) { add_pair(x, y, x, y + 1); });
  }
}

}  // namespace facet
