#include "surface/outline_hull.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace facet {
namespace {

struct Column {
  int top = std::numeric_limits<int>::max(), bottom = std::numeric_limits<int>::min();

  bool empty() const { return bottom < top; }
  void add(int y) { top = std::min(top, y), bottom = std::max(bottom, y); }
};

/// The columns of an outline from its leftmost one on.
std::vector<Column> columns_of(const Polyline& outline, int& x0) {
  int x1 = std::numeric_limits<int>::min();
  x0 = std::numeric_limits<int>::max();
  for (const ContourPoint& p : outline) x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
  std::vector<Column> columns(static_cast<std::size_t>(x1 - x0 + 1));
  for (const ContourPoint& p : outline) columns[static_cast<std::size_t>(p.x - x0)].add(p.y);
  return columns;
}

/// Adds a point to the corners from `begin` on, of which those go that it makes a straight line or a dent.
void add(std::vector<ContourPoint>& corners, std::size_t begin, ContourPoint p) {
  const auto turn = [&](ContourPoint a, ContourPoint b) {
    return std::int64_t{b.x - a.x} * (p.y - a.y) - std::int64_t{b.y - a.y} * (p.x - a.x);
  };
  while (corners.size() >= begin + 2 && turn(corners[corners.size() - 2], corners.back()) <= 0)
    corners.pop_back();
  corners.push_back(p);
}

/// Corners of the hull of what the columns hold, each at least once.
std::vector<ContourPoint> corners_of(const std::vector<Column>& columns, int x0) {
  std::vector<ContourPoint> corners;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (!columns[i].empty()) add(corners, 0, {x0 + static_cast<int>(i), columns[i].top});
  const std::size_t lower = corners.size();
  for (std::size_t i = columns.size(); i-- > 0;)
    if (!columns[i].empty()) add(corners, lower, {x0 + static_cast<int>(i), columns[i].bottom});
  return corners;
}

}  // namespace

Polyline convex_corners(const Polyline& outline) {
  if (outline.empty()) return {};
  int x0 = 0;
  std::vector<Column> columns = columns_of(outline, x0);
  const std::vector<ContourPoint> corners = corners_of(columns, x0);
  std::fill(columns.begin(), columns.end(), Column{});  // from now on of the corners alone
  for (const ContourPoint& p : corners) columns[static_cast<std::size_t>(p.x - x0)].add(p.y);
  Polyline in_order;
  for (const ContourPoint& p : outline) {
    const Column& column = columns[static_cast<std::size_t>(p.x - x0)];
    if (p.y == column.top || p.y == column.bottom) in_order.push_back(p);
  }
  return in_order;
}

}  // namespace facet
