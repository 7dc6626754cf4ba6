#include "edge_pairs/segments.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/image.hpp"
#include "core/neighbours.hpp"

namespace facet {
namespace {

/// Takes an edge map apart into chains of pixels.
class Linker {
 public:
  explicit Linker(ImageView<const std::uint8_t> edges) : left_(edges.size(), 0) {
    const auto is_edge = [&](int x, int y) { return edges.size().contains(x, y) && edges(x, y) != 0; };
    for (int y = 0; y < edges.height; ++y)
      for (int x = 0; x < edges.width; ++x) {
        if (!is_edge(x, y)) continue;
        int neighbours = 0;
        for (int i = 0; i < 8; ++i) neighbours += is_edge(x + neighbour8(i).dx, y + neighbour8(i).dy);
        left_(x, y) = neighbours <= 2;  // more: a junction, which ends the chains that meet in it
      }
  }

  /// Open chains first, from their ends; what is left then are loops.
  std::vector<Polyline> link() {
    std::vector<Polyline> chains;
    for (const int most_neighbours : {1, 2})
      for (int y = 0; y < left_.height(); ++y)
        for (int x = 0; x < left_.width(); ++x)
          if (left_(x, y) != 0 && count_around(x, y) <= most_neighbours) chains.push_back(follow({x, y}));
    return chains;
  }

 private:
  bool is_left(int x, int y) const { return left_.size().contains(x, y) && left_(x, y) != 0; }
  int count_around(int x, int y) const {
    int count = 0;
    for (int i = 0; i < 8; ++i) count += is_left(x + neighbour8(i).dx, y + neighbour8(i).dy);
    return count;
  }
  Polyline follow(ContourPoint p) {
    Polyline chain;
    while (true) {
      chain.push_back(p);
      left_(p.x, p.y) = 0;
      int next = -1;
      for (const int i : {0, 2, 4, 6, 1, 3, 5, 7})  // straight neighbours before diagonal ones
        if (next < 0 && is_left(p.x + neighbour8(i).dx, p.y + neighbour8(i).dy)) next = i;
      if (next < 0) return chain;
      p = {p.x + neighbour8(next).dx, p.y + neighbour8(next).dy};
    }
  }

  Image<std::uint8_t> left_;
};

Vec2 to_vec(ContourPoint p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

void split_chain(const Polyline& chain, const EdgePairParams& params, std::vector<Segment>& segments) {
  std::vector<cv::Point> curve, corners;
  for (const ContourPoint p : chain) curve.emplace_back(p.x, p.y);
  cv::approxPolyDP(curve, corners, static_cast<double>(params.line_tolerance_px), false);
  std::size_t begin = 0;
  for (std::size_t c = 1; c < corners.size(); ++c) {
    std::size_t end = begin;
    while (end < curve.size() && curve[end] != corners[c]) ++end;
    if (end == curve.size()) return;
    Segment segment{to_vec(chain[begin]), to_vec(chain[end]), {}};
    segment.pixels.assign(chain.begin() + static_cast<std::ptrdiff_t>(begin),
                          chain.begin() + static_cast<std::ptrdiff_t>(end) + 1);
    if (norm(segment.to - segment.from) >= params.min_length_px) segments.push_back(std::move(segment));
    begin = end;
  }
}

Vec2 direction_of(const Segment& s) {
  return normalized(s.to - s.from);
}

/// The two ends that are farthest apart, if the segments go on in one line; from == to otherwise.
Segment merged(const Segment& a, const Segment& b, const EdgePairParams& params) {
  const Vec2 t = direction_of(a);
  const double least_cos = std::cos(static_cast<double>(params.merge_deg) * CV_PI / 180);
  if (std::abs(dot(t, direction_of(b))) < least_cos) return {};
  const auto offset = [&](Vec2 p) { return std::abs(cross(t, p - a.from)); };
  if (std::max(offset(b.from), offset(b.to)) > static_cast<double>(params.merge_offset_px)) return {};
  const double length = norm(a.to - a.from);
  const double p = dot(t, b.from - a.from), q = dot(t, b.to - a.from);
  const double low = std::min(p, q), high = std::max(p, q);
  const double gap = std::max(low - length, -high);
  if (gap > static_cast<double>(params.merge_gap_px)) return {};
  Segment joined{low < 0 ? (p < q ? b.from : b.to) : a.from, high > length ? (p < q ? b.to : b.from) : a.to,
                 a.pixels};
  joined.pixels.insert(joined.pixels.end(), b.pixels.begin(), b.pixels.end());
  return joined;
}

void merge_collinear(const EdgePairParams& params, std::vector<Segment>& segments) {
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t j = i + 1; j < segments.size();) {
      Segment joined = merged(segments[i], segments[j], params);
      if (joined.pixels.empty()) {
        ++j;
        continue;
      }
      segments[i] = std::move(joined);
      segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;  // the longer piece may reach what it did not before
    }
}

}  // namespace

std::vector<Segment> find_segments(const EdgePairParams& params, ImageView<const std::uint8_t> edges) {
  std::vector<Segment> segments;
  for (const Polyline& chain : Linker(edges).link()) split_chain(chain, params, segments);
  merge_collinear(params, segments);
  return segments;
}

}  // namespace facet
