#include "score/boundary_match.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "score/edge_score.hpp"
#include "score/offsets.hpp"

namespace facet {
namespace {

constexpr int none = -1;

/// Bipartite graph of the pixels of two sets that are near each other, never written out: the neighbours of
/// a pixel stand in an image.
class PixelMatching {
 public:
  PixelMatching(const std::vector<ContourPoint>& a, const std::vector<ContourPoint>& b, Size size,
                double tolerance_px)
      : a_(a), offsets_(offsets_within(tolerance_px)), b_at_(size, none) {
    for (std::size_t i = 0; i < b.size(); ++i) b_at_(b[i].x, b[i].y) = static_cast<std::int32_t>(i);
    b_of_a_.assign(a.size(), none);
    a_of_b_.assign(b.size(), none);
  }

  int solve() {
    pair_nearest();
    while (find_levels()) {
      next_offset_.assign(a_.size(), 0);
      for (std::size_t i = 0; i < a_.size(); ++i)
        if (b_of_a_[i] == none && level_[i] == 0) augment(static_cast<int>(i));
    }
    return static_cast<int>(
        std::count_if(b_of_a_.begin(), b_of_a_.end(), [](int partner) { return partner != none; }));
  }

 private:
  /// The b at the k-th offset from an a, or none.
  int neighbour(int a, std::size_t k) const {
    const int x = a_[static_cast<std::size_t>(a)].x + offsets_[k].dx;
    const int y = a_[static_cast<std::size_t>(a)].y + offsets_[k].dy;
    return b_at_.size().contains(x, y) ? b_at_(x, y) : none;
  }

  void pair(int a, int b) {
    b_of_a_[static_cast<std::size_t>(a)] = b;
    a_of_b_[static_cast<std::size_t>(b)] = a;
  }

  void pair_nearest() {
    for (std::size_t k = 0; k < offsets_.size(); ++k) {
      for (int a = 0; a < static_cast<int>(a_.size()); ++a) {
        if (b_of_a_[static_cast<std::size_t>(a)] != none) continue;
        const int b = neighbour(a, k);
        if (b != none && a_of_b_[static_cast<std::size_t>(b)] == none) pair(a, b);
      }
    }
  }

  /// Breadth first from the free a; true if a free b can be reached.
  bool find_levels() {
    level_.assign(a_.size(), none);
    std::vector<int> queue;
    for (std::size_t i = 0; i < a_.size(); ++i)
      if (b_of_a_[i] == none) level_[i] = 0, queue.push_back(static_cast<int>(i));
    int last_level = none;  // of the shortest ways to a free b; later levels are of no use
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const int a = queue[head], level = level_[static_cast<std::size_t>(a)];
      if (last_level != none && level > last_level) break;
      for (std::size_t k = 0; k < offsets_.size(); ++k) {
        const int b = neighbour(a, k);
        if (b == none) continue;
        const int partner = a_of_b_[static_cast<std::size_t>(b)];
        if (partner == none) {
          last_level = level;
        } else if (level_[static_cast<std::size_t>(partner)] == none) {
          level_[static_cast<std::size_t>(partner)] = level + 1;
          queue.push_back(partner);
        }
      }
    }
    return last_level != none;
  }

  /// Depth first along the levels, without recursion: ways can be as long as an edge.
  void augment(int start) {
    std::vector<std::pair<int, int>> way;  // a and the b it leaves by
    int a = start;
    while (true) {
      const int b = next_step(a);
      if (b != none) {
        way.push_back({a, b});
        a = a_of_b_[static_cast<std::size_t>(b)];
        if (a != none) continue;
        for (const auto& [from, to] : way) pair(from, to);
        return;
      }
      level_[static_cast<std::size_t>(a)] = none;
      if (way.empty()) return;
      a = way.back().first;
      way.pop_back();
    }
  }

  int next_step(int a) {
    std::size_t& k = next_offset_[static_cast<std::size_t>(a)];
    while (k < offsets_.size()) {
      const int b = neighbour(a, k++);
      if (b == none) continue;
      const int partner = a_of_b_[static_cast<std::size_t>(b)];
      if (partner == none ||
          level_[static_cast<std::size_t>(partner)] == level_[static_cast<std::size_t>(a)] + 1)
        return b;
    }
    return none;
  }

  const std::vector<ContourPoint>& a_;
  std::vector<GridOffset> offsets_;
  Image<std::int32_t> b_at_;
  std::vector<int> b_of_a_, a_of_b_, level_;
  std::vector<std::size_t> next_offset_;
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
      const auto kind = static_cast<EdgeKind>(codes(x, y) & ~graspable_edge_bit);
      if (is_in_group(kind, group) && is_of_interest(frame, x, y, frame.tolerance_px()))
        predicted.push_back({x, y});
    }
  }
  return {match_one_to_one(truth, predicted, frame.size, frame.tolerance_px()),
          static_cast<int>(predicted.size()), static_cast<int>(truth.size())};
}

}  // namespace facet
