#include "score/object_masks.hpp"

#include <numeric>

#include "score/region_outlines.hpp"

namespace facet {
namespace {

void count_leakage(const RegionComparison& comparison, ObjectMaskScore& score) {
  const TruthLabels& truth = comparison.truth;
  const std::vector<Overlap>& overlaps = comparison.overlaps;
  const std::size_t count = comparison.predicted.regions.size();
  std::vector<int> none_px(count), largest_px(count, 0), majority(count, -1);
  for (std::size_t r = 0; r < count; ++r) none_px[r] = comparison.predicted.regions[r].area_px;
  for (const Overlap& o : overlaps) {
    const auto r = static_cast<std::size_t>(o.b);
    none_px[r] -= o.px;
    if (o.px > largest_px[r]) largest_px[r] = o.px, majority[r] = o.a;
  }
  for (std::size_t r = 0; r < count; ++r)
    if (none_px[r] > largest_px[r]) majority[r] = -1;
  score.leakage.n = score.coverage.n = std::accumulate(truth.area_px.begin(), truth.area_px.end(), 0);
  for (const Overlap& o : overlaps) {
    score.coverage.hit += o.px;
    if (majority[static_cast<std::size_t>(o.b)] != o.a) score.leakage.hit += o.px;
  }
}

}  // namespace

ObjectMaskScore score_object_masks(const RegionComparison& comparison) {
  const std::vector<Outline>& outlines = comparison.outlines;
  ObjectMaskScore score;
  count_leakage(comparison, score);
  Outline of_objects, of_regions, of_compared;
  for (const Outline& outline : comparison.truth.outlines)
    of_objects.insert(of_objects.end(), outline.begin(), outline.end());
  for (std::size_t r = 0; r < outlines.size(); ++r) {
    of_regions.insert(of_regions.end(), outlines[r].begin(), outlines[r].end());
    if (is_compared(comparison.classes[r]))
      of_compared.insert(of_compared.end(), outlines[r].begin(), outlines[r].end());
  }
  NearbyCounter nearby(comparison.truth.map.size(), boundary_radius_px(comparison.truth.map.size()));
  score.outline_recall = {nearby.count(of_objects, of_regions), static_cast<int>(of_objects.size())};
  score.outline_precision = {nearby.count(of_compared, of_objects), static_cast<int>(of_compared.size())};
  return score;
}

}  // namespace facet
