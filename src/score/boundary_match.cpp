#include "score/boundary_match.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

#include "score/edge_score.hpp"
#include "score/offsets.hpp"

namespace facet {
namespace {

constexpr int none = -1;

/// Bipartite graph of the pixels of two sets that are near each other, never written out: the neighbours of
/// a pixel stand in an image, with a margin as wide as the tolerance.
class PixelMatching {
 public:
  PixelMatching(const std::vector<ContourPoint>& a, const std::vector<ContourPoint>& b, Size size,
                double tolerance_px)
      : b_of_a_(a.size(), none),
        a_of_b_(b.size(), none),
        came_from_(a.size(), none),
        visited_(a.size(), false) {
    const int margin = static_cast<int>(std::ceil(tolerance_px)) + 1;
    b_at_ = Image<std::int32_t>({size.width + 2 * margin, size.height + 2 * margin}, none);
    for (std::size_t i = 0; i < b.size(); ++i)
      b_at_(b[i].x + margin, b[i].y + margin) = static_cast<std::int32_t>(i);
    for (const ContourPoint p : a) place_of_a_.push_back(&b_at_(p.x + margin, p.y + margin));
    for (const GridOffset& o : offsets_within(tolerance_px))
      steps_.push_back(static_cast<std::ptrdiff_t>(o.dy) * b_at_.stride() + o.dx);
  }

  int solve() {
    pair_nearest();
    int matched = 0;
    for (int a = 0; a < static_cast<int>(b_of_a_.size()); ++a)
      if (b_of_a_[static_cast<std::size_t>(a)] != none || augment(a)) ++matched;
    return matched;
  }

 private:
  /// The b at the k-th step from an a, nearest first, or none.
  int neighbour(int a, std::size_t k) const { return place_of_a_[static_cast<std::size_t>(a)][steps_[k]]; }

  void pair(int a, int b) {
    b_of_a_[static_cast<std::size_t>(a)] = b;
    a_of_b_[static_cast<std::size_t>(b)] = a;
  }

  void pair_nearest() {
    std::vector<int> free_a(b_of_a_.size());
    std::iota(free_a.begin(), free_a.end(), 0);
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      std::erase_if(free_a, [&](int a) {
        const int b = neighbour(a, k);
        if (b == none || a_of_b_[static_cast<std::size_t>(b)] != none) return false;
        pair(a, b);
        return true;
      });
    }
  }

  /// Searches a shortest way from a free a to a free b, breadth first, and moves the pairs along it. Pixels
  /// from which there is none now will never have one: they stay visited and are not searched again.
  bool augment(int start) {
    std::vector<int> queue{start};
    visited_[static_cast<std::size_t>(start)] = true;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const int a = queue[head];
      for (std::size_t k = 0; k < steps_.size(); ++k) {
        const int b = neighbour(a, k);
        if (b == none) continue;
        const int partner = a_of_b_[static_cast<std::size_t>(b)];
        if (partner == none) {
          move_pairs(start, a, b);
          for (const int seen : queue) visited_[static_cast<std::size_t>(seen)] = false;
          return true;
        }
        if (visited_[static_cast<std::size_t>(partner)]) continue;
        visited_[static_cast<std::size_t>(partner)] = true;
        came_from_[static_cast<std::size_t>(partner)] = a;
        queue.push_back(partner);
      }
    }
    return false;
  }

  /// Gives b to a, what a had to the one it was reached from, and so on back to the start.
  void move_pairs(int start, int a, int b) {
    while (true) {
      const int given_up = b_of_a_[static_cast<std::size_t>(a)];
      pair(a, b);
      if (a == start) return;
      a = came_from_[static_cast<std::size_t>(a)];
      b = given_up;
    }
  }

  Image<std::int32_t> b_at_;
  std::vector<const std::int32_t*> place_of_a_;  ///< in b_at_
  std::vector<std::ptrdiff_t> steps_;
  std::vector<int> b_of_a_, a_of_b_, came_from_;
  std::vector<bool> visited_;  ///< a
};

bool is_in_group(EdgeKind kind, EdgeGroup group) {
  return kind != EdgeKind::none && (kind == EdgeKind::depth) == (group == EdgeGroup::depth);
}

}  // namespace

int match_one_to_one(const std::vector<ContourPoint>& a, const std::vector<ContourPoint>& b, Size size,
                     double tolerance_px) {
  return PixelMatching(a, b, size, tolerance_px).solve();
}

std::vector<ContourPoint> boundary_truth(const FrameTruth& frame, EdgeGroup group) {
  std::set<std::tuple<EdgeKind, int, int>> pixels;
  for (const ScoredEdge& edge : frame.edges) {
    if (!is_in_group(edge.kind, group)) continue;
    for (const ImagePoint s : edge.samples)
      pixels.insert({edge.kind, static_cast<int>(std::lround(s.y)), static_cast<int>(std::lround(s.x))});
  }
  std::vector<ContourPoint> points;
  for (const auto& [kind, y, x] : pixels)
    if (frame.size.contains(x, y)) points.push_back({x, y});
  return points;
}

BoundaryCounts score_boundary(const FrameTruth& frame, const Image<std::uint8_t>& codes, EdgeGroup group) {
  const std::vector<ContourPoint> truth = boundary_truth(frame, group);
  std::vector<ContourPoint> predicted;
  for (int y = 0; y < codes.height(); ++y) {
    for (int x = 0; x < codes.width(); ++x) {
      const auto kind = edge_kind_of(codes(x, y));
      if (is_in_group(kind, group) && is_of_interest(frame, x, y, frame.tolerance_px()))
        predicted.push_back({x, y});
    }
  }
  return {match_one_to_one(truth, predicted, frame.size, frame.tolerance_px()),
          static_cast<int>(predicted.size()), static_cast<int>(truth.size())};
}

}  // namespace facet
