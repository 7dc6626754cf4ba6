#include "score/region_match.hpp"

#include "score/assignment.hpp"

namespace facet {

std::vector<RegionMatch> match_regions(const TruthLabels& truth, const PredictedRegions& predicted,
                                       const std::vector<Overlap>& overlaps, double threshold) {
  std::vector<WeightedPair> pairs;
  for (const Overlap& o : overlaps) {
    const double iou = overlap_share(o.px, truth.area_px[static_cast<std::size_t>(o.a)],
                                     predicted.regions[static_cast<std::size_t>(o.b)].area_px);
    if (iou >= threshold) pairs.push_back({o.a, o.b, iou});
  }
  std::vector<RegionMatch> matches;
  for (const WeightedPair& pair : best_assignment(pairs))
    matches.push_back({pair.row, pair.column, pair.weight});
  return matches;
}

std::vector<RegionClass> classify_regions(const FrameTruth& truth, const PredictedRegions& predicted,
                                          const std::vector<Overlap>& overlaps,
                                          const std::vector<RegionMatch>& matches) {
  const std::size_t count = predicted.regions.size();
  std::vector<RegionClass> classes(count, RegionClass::background);
  std::vector<int> on_items_px(count, 0);
  for (const Overlap& o : overlaps) on_items_px[static_cast<std::size_t>(o.b)] += o.px;
  for (std::size_t r = 0; r < count; ++r) {
    const PredictedRegion& region = predicted.regions[r];
    if (region.void_px > region.area_px) {
      classes[r] = RegionClass::ignored;
    } else if (region.area_px < counted_surface_px) {
      classes[r] = RegionClass::tiny;
    } else if (2 * (on_items_px[r] + region.support_px) > region.area_px) {
      classes[r] = RegionClass::wrong;
    }
  }
  for (const RegionMatch& match : matches)
    classes[static_cast<std::size_t>(match.region)] = RegionClass::matched;
  std::vector<Overlap> largest(truth.support_parts.parts.size());
  for (const Overlap& o : count_overlaps(truth.support_parts.map, predicted.map)) {
    const auto region = static_cast<std::size_t>(o.b);
    const bool candidate = classes[region] == RegionClass::wrong &&
                           2 * predicted.regions[region].support_px > predicted.regions[region].area_px;
    if (candidate && o.px > largest[static_cast<std::size_t>(o.a)].px)
      largest[static_cast<std::size_t>(o.a)] = o;
  }
  for (const Overlap& o : largest)
    if (o.px > 0) classes[static_cast<std::size_t>(o.b)] = RegionClass::table;
  return classes;
}

RegionComparison compare_regions(const FrameTruth& frame, const TruthLabels& truth,
                                 PredictedRegions predicted) {
  std::vector<Overlap> overlaps = count_overlaps(truth.map, predicted.map);
  std::vector<RegionMatch> matches = match_regions(truth, predicted, overlaps, 0.5);
  std::vector<RegionClass> classes = classify_regions(frame, predicted, overlaps, matches);
  std::vector<Outline> outlines = region_outlines(predicted.map, predicted.regions.size(), truth.regions);
  return {truth,
          std::move(predicted),
          std::move(overlaps),
          std::move(matches),
          std::move(classes),
          std::move(outlines)};
}

}  // namespace facet
