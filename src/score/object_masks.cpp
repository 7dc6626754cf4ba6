#include "score/object_masks.hpp"

#include <numeric>

#include "score/region_outlines.hpp"

namespace facet {
namespace {

void count_leakage(const FrameTruth& frame, const PredictedRegions& predicted,
                   const std::vector<Overlap>& overlaps, ObjectMaskScore& score) {
  const std::size_t count = predicted.regions.size();
  std::vector<int> none_px(count), largest_px(count, 0), majority(count, -1);
  for (std::size_t r = 0; r < count; ++r) none_px[r] = predicted.regions[r].area_px;
  for (const Overlap& o : overlaps) {
    const auto r = static_cast<std::size_t>(o.b);
    none_px[r] -= o.px;
    if (o.px > largest_px[r]) largest_px[r] = o.px, majority[r] = o.a;
  }
  for (std::size_t r = 0; r < count; ++r)
    if (none_px[r] > largest_px[r]) majority[r] = -1;
  score.leakage.n = score.coverage.n =
      std::accumulate(frame.objects.area_px.begin(), frame.objects.area_px.end(), 0);
  for (const Overlap& o : overlaps) {
    score.coverage.hit += o.px;
    if (majority[static_cast<std::size_t>(o.b)] != o.a) score.leakage.hit += o.px;
  }
}

}  // namespace

ObjectMaskScore score_object_masks(const FrameTruth& frame, const PredictedRegions& predicted,
                                   const std::vector<Overlap>& overlaps,
                                   const std::vector<RegionClass>& classes) {
  ObjectMaskScore score;
  count_leakage(frame, predicted, overlaps, score);
  std::vector<ContourPoint> of_objects, of_regions, of_compared;
  for (const auto& outline : region_outlines(frame.objects.map, frame.objects.size(), frame.regions))
    of_objects.insert(of_objects.end(), outline.begin(), outline.end());
  const auto outlines = region_outlines(predicted.map, predicted.regions.size(), frame.regions);
  for (std::size_t r = 0; r < outlines.size(); ++r) {
    of_regions.insert(of_regions.end(), outlines[r].begin(), outlines[r].end());
    if (is_compared(classes[r]))
      of_compared.insert(of_compared.end(), outlines[r].begin(), outlines[r].end());
  }
  NearbyCounter nearby(frame.size, boundary_radius_px(frame.size));
  score.outline_recall = {nearby.count(of_objects, of_regions), static_cast<int>(of_objects.size())};
  score.outline_precision = {nearby.count(of_compared, of_objects), static_cast<int>(of_compared.size())};
  return score;
}

}  // namespace facet
