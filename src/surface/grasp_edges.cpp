#include "surface/grasp_edges.hpp"

#include <algorithm>
#include <cmath>

#include "core/neighbours.hpp"

namespace facet {
namespace {

/// Shorter interruptions of a graspable edge are slips of the edge's kind.
constexpr std::size_t closed_gap_px = 8;

Vec2 to_vec(ContourPoint p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

/// Whether an edge pixel lets a finger reach the surface `id` beside it.
bool serves(ImageView<const std::uint16_t> labels, ImageView<const std::uint8_t> edges, ContourPoint p,
            int id) {
  const int code = edges(p.x, p.y);
  if ((code & graspable_edge_bit) == 0) return false;
  const bool is_depth_edge = code == edge_code(EdgeKind::depth, true);
  return !is_depth_edge || labels(p.x, p.y) == id;
}

bool is_graspable(ImageView<const std::uint16_t> labels, ImageView<const std::uint8_t> edges, ContourPoint p,
                  int id) {
  if (edges(p.x, p.y) != 0) return serves(labels, edges, p, id);
  for (int i = 0; i < 8; ++i) {
    const ContourPoint q{p.x + neighbour8(i).dx, p.y + neighbour8(i).dy};
    if (edges.size().contains(q.x, q.y) && serves(labels, edges, q, id)) return true;
  }
  return false;
}

/// An index less than 2 n of a closed line with n points. A division would take longer than all else that is
/// done to a point.
std::size_t wrapped(std::size_t i, std::size_t n) {
  return i < n ? i : i - n;
}

/// Twice the area on the side left_of() the outline's direction.
std::int64_t doubled_area(const Polyline& outline) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const ContourPoint p = outline[i], q = outline[wrapped(i + 1, outline.size())];
    sum += std::int64_t{p.x} * q.y - std::int64_t{p.y} * q.x;
  }
  return sum;
}

std::size_t farthest_from_mean(const Polyline& outline) {
  Vec2 mean;
  for (const ContourPoint& p : outline) mean = mean + to_vec(p);
  mean = (1 / static_cast<double>(outline.size())) * mean;
  std::size_t farthest = 0;
  double largest = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const double distance = norm(to_vec(outline[i]) - mean);
    if (distance > largest) largest = distance, farthest = i;
  }
  return farthest;
}

}  // namespace

const std::vector<StraightEdge>& GraspableEdges::find(const Surface& surface,
                                                      ImageView<const std::uint16_t> labels,
                                                      ImageView<const std::uint8_t> edges,
                                                      double tolerance_px) {
  tolerance_px_ = tolerance_px;
  edges_.clear();
  points_.clear();
  runs_.clear();
  const Polyline& outline = surface.contour.outer;
  graspable_.resize(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i)
    graspable_[i] = is_graspable(labels, edges, outline[i], surface.id);
  collect(outline);
  const bool reversed = doubled_area(outline) < 0;
  for (const Range& run : runs_) {
    ranges_.clear();
    split(run);
    join();
    for (const Range& range : ranges_) {
      StraightEdge edge = fit(range);
      if (reversed) std::swap(edge.from, edge.to);
      const Vec2 outward = -0.5 * normalized(left_of(edge.to - edge.from));  // centre to border of the pixels
      edges_.push_back({edge.from + outward, edge.to + outward});
    }
  }
  return edges_;
}

/// Runs of graspable pixels. The outline is closed: it is opened after its longest gap, or, where a finger
/// reaches all round, at the pixel farthest from its mean, which is a corner if there are any.
void GraspableEdges::collect(const Polyline& outline) {
  const std::size_t n = outline.size();
  const auto first = static_cast<std::size_t>(
      std::find(graspable_.begin(), graspable_.end(), std::uint8_t{1}) - graspable_.begin());
  if (first == n) return;
  std::size_t start = first, longest = 0, gap = 0;
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = wrapped(first + k, n);
    if (!graspable_[i]) {
      ++gap;
      continue;
    }
    if (gap > longest) longest = gap, start = i;
    gap = 0;
  }
  if (longest < closed_gap_px) return add_run(outline, farthest_from_mean(outline), n + 1);
  std::size_t begin = 0, end = 0;  // of the run, from the start; the longest gap ends the last one
  for (std::size_t k = 0; k < n; ++k) {
    if (!graspable_[wrapped(start + k, n)]) continue;
    if (k - end >= closed_gap_px) {
      add_run(outline, start + begin, end - begin);
      begin = k;
    }
    end = k + 1;
  }
  add_run(outline, start + begin, end - begin);
}

void GraspableEdges::add_run(const Polyline& outline, std::size_t first, std::size_t count) {
  if (count < 2) return;
  const std::size_t begin = points_.size();
  for (std::size_t k = 0; k < count; ++k)
    points_.push_back(to_vec(outline[wrapped(first + k, outline.size())]));
  runs_.emplace_back(begin, points_.size() - 1);
}

void GraspableEdges::split(Range range) {
  const std::size_t at = farthest_from_chord(range);
  if (at == range.first || at == range.second || is_straight(range)) {
    ranges_.push_back(range);
    return;
  }
  split({range.first, at});
  split({at, range.second});
}

/// Splitting cuts straight edges, too, where neither end of the chord was a corner.
void GraspableEdges::join() {
  std::size_t kept = 0;
  for (std::size_t i = 1; i < ranges_.size(); ++i) {
    const Range both{ranges_[kept].first, ranges_[i].second};
    if (is_straight(both))
      ranges_[kept] = both;
    else
      ranges_[++kept] = ranges_[i];
  }
  ranges_.resize(kept + 1);
}

/// Line of least squared distances, from the foot of the first pixel to that of the last.
StraightEdge GraspableEdges::fit(Range range) const {
  const auto count = static_cast<double>(range.second - range.first + 1);
  Vec2 mean;
  for (std::size_t i = range.first; i <= range.second; ++i) mean = mean + points_[i];
  mean = (1 / count) * mean;
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t i = range.first; i <= range.second; ++i) {
    const Vec2 d = points_[i] - mean;
    xx += d.x * d.x, xy += d.x * d.y, yy += d.y * d.y;
  }
  const double larger = 0.5 * (xx + yy) + std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
  const Vec2 direction = normalized(xx >= yy ? Vec2{larger - yy, xy} : Vec2{xy, larger - xx});
  const auto foot = [&](Vec2 p) { return mean + dot(p - mean, direction) * direction; };
  return {foot(points_[range.first]), foot(points_[range.second])};
}

bool GraspableEdges::is_straight(Range range) const {
  const StraightEdge line = fit(range);
  const Vec2 direction = normalized(line.to - line.from);
  for (std::size_t i = range.first; i <= range.second; ++i)
    if (!(std::fabs(cross(direction, points_[i] - line.from)) <= tolerance_px_)) return false;
  return direction != Vec2{};
}

std::size_t GraspableEdges::farthest_from_chord(Range range) const {
  const Vec2 from = points_[range.first], chord = points_[range.second] - from;
  const bool is_closed = chord == Vec2{};
  std::size_t farthest = range.first;
  double largest = 0;
  for (std::size_t i = range.first; i <= range.second; ++i) {
    const Vec2 d = points_[i] - from;
    const double distance = is_closed ? dot(d, d) : std::fabs(cross(chord, d));
    if (distance > largest) largest = distance, farthest = i;
  }
  return farthest;
}

}  // namespace facet
