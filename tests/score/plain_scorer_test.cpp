// The scorers against plain ones that loop over everything, on random masks and lines.
#include <cmath>
#include <gtest/gtest.h>
#include <map>

#include "score/frame_score.hpp"
#include "score/polyline_distance.hpp"
#include "support/masks.hpp"

namespace facet {
namespace {

constexpr Size random_sizes[]{{31, 7}, {33, 9}, {64, 48}, {97, 61}};

/// Labels 0 ... `count` in irregular blocks.
Image<std::uint16_t> random_labels(Size size, std::uint64_t seed, int period_px, int count) {
  const Mask blobs = blob_mask(size, seed, period_px);
  return make_image<std::uint16_t>(size, [&](int x, int y) {
    const float u = noise_at(seed + 9, x / period_px, y / period_px);
    return blobs(x, y) ? static_cast<int>(u * static_cast<float>(count + 1)) : 0;
  });
}

FrameTruth random_truth(Size size, std::uint64_t seed) {
  const Image<float> depth =
      make_image<float>(size, [&](int x, int y) { return noise_at(seed, x / 3, y / 3) < 0.1f ? 0 : 1; });
  return frame_truth(random_labels(size, seed, 16, 4), depth);
}

/// Sum of the weights of the best one-to-one choice, by trying everything.
double best_total(const std::map<std::pair<int, int>, double>& weights, int row, int rows,
                  std::vector<bool>& taken) {
  if (row == rows) return 0;
  double best = best_total(weights, row + 1, rows, taken);
  for (std::size_t c = 0; c < taken.size(); ++c) {
    const auto w = weights.find({row, static_cast<int>(c)});
    if (taken[c] || w == weights.end()) continue;
    taken[c] = true;
    best = std::max(best, w->second + best_total(weights, row + 1, rows, taken));
    taken[c] = false;
  }
  return best;
}

TEST(PlainScorer, CountsTheSameOverlapsAndMatchesWithTheSameTotal) {
  int matched = 0;
  for (const Size size : random_sizes) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const FrameTruth frame = random_truth(size, seed);
      Prediction prediction;
      prediction.labels = random_labels(size, seed % 3 ? seed : seed + 50, 15, 6);
      const RegionComparison c = compare_regions(frame, frame.objects, object_regions(frame, prediction));
      std::map<std::pair<int, int>, int> common;
      std::map<int, int> area_t, area_r;
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          if (frame.objects.regions(x, y) == TruthRegion::ignored) continue;
          const int t = frame.objects.map(x, y), r = prediction.labels(x, y);
          ++area_t[t], ++area_r[r];
          if (t && r) ++common[{t, r}];
        }
      }
      ASSERT_EQ(c.overlaps.size(), common.size());
      std::map<std::pair<int, int>, double> iou;
      for (const Overlap& o : c.overlaps) {
        const int id = c.predicted.regions[static_cast<std::size_t>(o.b)].ids[0];
        EXPECT_EQ(o.px, (common[{o.a + 1, id}]));
        const double share = 1.0 * o.px / (area_t[o.a + 1] + area_r[id] - o.px);
        if (share >= 0.2) iou[{o.a, o.b}] = share;
      }
      double total = 0;
      for (const RegionMatch& m : match_regions(frame.objects, c.predicted, c.overlaps, 0.2))
        total += m.iou, ++matched;
      std::vector<bool> taken(c.predicted.regions.size(), false);
      EXPECT_NEAR(total, best_total(iou, 0, static_cast<int>(frame.objects.size()), taken), 1e-12);
    }
  }
  EXPECT_GT(matched, 20);
}

/// Pixels of the label with a 4-neighbour outside of it that is joined, by 4-neighbours, to the image's
/// border, and without void among the eight neighbours.
std::vector<ContourPoint> plain_outline(const TruthLabels& truth, int label) {
  const Size size{truth.map.width() + 2, truth.map.height() + 2};
  Mask outside(size, 0);
  outside(0, 0) = 1;
  for (bool grows = true; grows;) {
    grows = false;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const bool inside = x > 0 && y > 0 && x <= truth.map.width() && y <= truth.map.height();
        if (outside(x, y) || (inside && truth.map(x - 1, y - 1) == label)) continue;
        for (const auto& [dx, dy] : {std::pair{0, 1}, {0, -1}, {1, 0}, {-1, 0}})
          if (size.contains(x + dx, y + dy) && outside(x + dx, y + dy)) outside(x, y) = 1, grows = true;
      }
    }
  }
  std::vector<ContourPoint> points;
  for (int y = 0; y < truth.map.height(); ++y) {
    for (int x = 0; x < truth.map.width(); ++x) {
      if (truth.map(x, y) != label) continue;
      bool border = false, at_void = false;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          border = border || (std::abs(dx) + std::abs(dy) == 1 && outside(x + 1 + dx, y + 1 + dy));
          at_void = at_void || (truth.map.size().contains(x + dx, y + dy) &&
                                truth.regions(x + dx, y + dy) == TruthRegion::ignored);
        }
      }
      if (border && !at_void) points.push_back({x, y});
    }
  }
  return points;
}

TEST(PlainScorer, DrawsTheSameOutlinesAndFindsTheSameNearPixels) {
  for (const Size size : random_sizes) {
    for (std::uint64_t seed = 20; seed < 24; ++seed) {
      const FrameTruth frame = random_truth(size, seed);
      for (std::size_t k = 0; k < frame.objects.size(); ++k)
        EXPECT_EQ(frame.objects.outlines[k], plain_outline(frame.objects, static_cast<int>(k) + 1));
      NearbyCounter nearby(size, 2.5);
      for (std::size_t k = 1; k < frame.objects.size(); ++k) {
        const Outline &a = frame.objects.outlines[k - 1], &b = frame.objects.outlines[k];
        const auto plain = std::count_if(a.begin(), a.end(), [&](ContourPoint p) {
          return std::any_of(b.begin(), b.end(),
                             [p](ContourPoint q) { return std::hypot(p.x - q.x, p.y - q.y) <= 2.5; });
        });
        EXPECT_EQ(nearby.count(a, b), plain);
      }
    }
  }
}

/// A truth of random polylines and a random edge image.
struct RandomEdges {
  Truth truth;
  Image<std::uint8_t> codes;

  explicit RandomEdges(std::uint64_t seed) : truth{.size = {97, 61}}, codes({97, 61}, 0) {
    std::uint64_t i = 0;
    const auto uniform = [&](double most) { return most * random_uniform(seed, 5, i++); };
    truth.surfaces.push_back({.number = 1, .object = 1, .parts = {{{{20, 20}, {60, 18}, {40, 45}}, 0}}});
    truth.ignore.push_back({{{50, 10}, {70, 10}, {70, 40}}, 1});
    for (int e = 0; e < 9; ++e) {
      TruthEdge edge{
          .number = e + 1, .object = 1, .kind = static_cast<EdgeKind>(1 + e % 3), .graspable = e % 2 == 0};
      for (int p = 0; p < 2 + e % 3; ++p) edge.line.push_back({uniform(96), uniform(60)});
      truth.edges.push_back(edge);
    }
    const Mask lines = line_mask(codes.size(), seed);
    for (int y = 0; y < codes.height(); ++y)
      for (int x = 0; x < codes.width(); ++x)
        if (lines(x, y))
          codes(x, y) = edge_code(static_cast<EdgeKind>(1 + random_below(3, seed, 6, i++)), uniform(1) < 0.8);
  }
};

TEST(PlainScorer, DetectsTheSameEdgesAtEveryTolerance) {
  int detected = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const RandomEdges random(seed);
    const FrameTruth frame = frame_truth(random.truth, {}, {});
    const EdgeScore score = score_edges(frame, random.codes);
    for (int tolerance = 1; tolerance <= edge_curve_px; ++tolerance) {
      Tally plain;
      for (const ScoredEdge& edge : frame.edges) {
        int hit = 0, right = 0;
        for (const ImagePoint s : edge.samples) {
          double nearest = 1e9;
          bool label = false;
          for (int y = 0; y < 61; ++y) {
            for (int x = 0; x < 97; ++x) {
              if ((random.codes(x, y) & 15) != static_cast<int>(edge.kind)) continue;
              const double d = std::hypot(x - s.x, y - s.y);
              const bool same = ((random.codes(x, y) & 16) != 0) == edge.graspable;
              label = d < nearest - 1e-6 ? same : std::abs(d - nearest) <= 1e-6 ? label || same : label;
              nearest = std::min(nearest, d);
            }
          }
          hit += nearest <= tolerance;
          right += nearest <= tolerance && label;
        }
        if (edge.counts)
          plain.add(hit > 0 && hit * 10 >= 7 * std::ssize(edge.samples) && right * 10 >= 7 * hit);
      }
      EXPECT_EQ(score.recall_curve[static_cast<std::size_t>(tolerance - 1)].all, plain)
          << seed << " at " << tolerance;
      detected += plain.hit;
    }
  }
  EXPECT_GT(detected, 20);
}

TEST(PlainScorer, FindsTheSameRightPixels) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const RandomEdges random(seed);
    const FrameTruth frame = frame_truth(random.truth, {}, {});
    Tally plain;
    for (int y = 0; y < 61; ++y) {
      for (int x = 0; x < 97; ++x) {
        if (random.codes(x, y) == 0) continue;
        double same = 1e9, any = 1e9, object = 1e9;
        for (const ScoredEdge& edge : frame.edges) {
          const double d = distance_px({1.0 * x, 1.0 * y}, edge.line);
          any = std::min(any, d);
          if ((random.codes(x, y) & 15) == static_cast<int>(edge.kind)) same = std::min(same, d);
        }
        for (int v = 0; v < 61; ++v)
          for (int u = 0; u < 97; ++u)
            if (frame.surface_object(u, v)) object = std::min(object, std::hypot(x - u, y - v));
        const bool is_void = frame.surfaces.regions(x, y) == TruthRegion::ignored;
        if (object <= 20 && (!is_void || any <= 3)) plain.add(same <= 3);
      }
    }
    EXPECT_EQ(score_edges(frame, random.codes).precision_3px.all, plain);
    EXPECT_GT(plain.hit, 0);
  }
}

}  // namespace
}  // namespace facet
