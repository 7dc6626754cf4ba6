#include "score/clutter.hpp"

#include <cmath>

#include "score/offsets.hpp"

namespace facet {
namespace {

/// What is seen on one side of an edge.
struct Side {
  int own = 0, others = 0;

  void add(const FrameTruth& frame, const ScoredEdge& edge, double x, double y) {
    const int px = static_cast<int>(std::lround(x)), py = static_cast<int>(std::lround(y));
    if (!frame.size.contains(px, py) || frame.surface_object(px, py) == 0) return;
    ++(frame.surface_object(px, py) == edge.object ? own : others);
  }
};

/// Number of samples behind which another object goes on.
int occluding_samples(const FrameTruth& frame, const ScoredEdge& edge) {
  int count = 0;
  const int last = static_cast<int>(edge.samples.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    const ImagePoint p = edge.samples[static_cast<std::size_t>(i)];
    const ImagePoint a = edge.samples[static_cast<std::size_t>(std::max(0, i - 1))];
    const ImagePoint b = edge.samples[static_cast<std::size_t>(std::min(last, i + 1))];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length == 0) continue;
    const double nx = -(b.y - a.y) / length, ny = (b.x - a.x) / length;
    Side left, right;
    for (double step = 1; step <= neighbourhood_px; ++step) {
      left.add(frame, edge, p.x + step * nx, p.y + step * ny);
      right.add(frame, edge, p.x - step * nx, p.y - step * ny);
    }
    if (left.own != right.own && (left.own < right.own ? left : right).others > 0) ++count;
  }
  return count;
}

bool is_contact(const FrameTruth& frame, const ScoredEdge& edge, const std::vector<GridOffset>& around) {
  std::size_t touching = 0;
  for (const ImagePoint s : edge.samples) {
    const int cx = static_cast<int>(std::lround(s.x)), cy = static_cast<int>(std::lround(s.y));
    for (const GridOffset& o : around) {
      const int x = cx + o.dx, y = cy + o.dy;
      if (!frame.size.contains(x, y) || frame.surface_object(x, y) == 0 ||
          frame.surface_object(x, y) == edge.object)
        continue;
      if (std::hypot(x - s.x, y - s.y) > neighbourhood_px + distance_slack_px) continue;
      ++touching;
      break;
    }
  }
  return 2 * touching >= edge.samples.size();
}

}  // namespace

Clutter clutter_of(const FrameTruth& frame) {
  Clutter clutter{
      .objects = static_cast<int>(frame.has_surfaces ? frame.scored_objects.size() : frame.objects.size()),
      .surfaces = static_cast<int>(frame.scored_surfaces.size())};
  const std::vector<GridOffset> around = offsets_within(neighbourhood_px + 1);
  int occluding = 0, depth_samples = 0;
  for (const ScoredEdge& edge : frame.edges) {
    if (!edge.counts) continue;
    if (edge.kind == EdgeKind::depth) {
      occluding += occluding_samples(frame, edge);
      depth_samples += static_cast<int>(edge.samples.size());
    } else if (edge.kind == EdgeKind::concave && is_contact(frame, edge, around)) {
      ++clutter.contacts;
    }
  }
  if (depth_samples > 0) clutter.occluded_share = static_cast<double>(occluding) / depth_samples;
  return clutter;
}

}  // namespace facet
