#pragma once

#include "score/predicted_regions.hpp"

namespace facet {

/// An item of the truth and the region that was found for it; indices.
struct RegionMatch {
  int truth = 0, region = 0;
  double iou = 0;
};

/// The one-to-one assignment with the largest total of IoU >= threshold, by item. `overlaps` holds the pixels
/// that items (a) and regions (b) share.
std::vector<RegionMatch> match_regions(const TruthLabels& truth, const PredictedRegions& predicted,
                                       const std::vector<Overlap>& overlaps, double threshold);

/// What a region is, given the matches.
enum class RegionClass {
  matched,
  table,       ///< the largest unmatched region on a part of the support
  background,  ///< unmatched, at least half of it on neither items nor support
  ignored,     ///< unmatched and mostly in void
  tiny,        ///< unmatched, under counted_surface_px without void pixels
  wrong,       ///< unmatched and more than half of it on items or support: a false region
};

/// One class per region. Rules are tried in the order void, tiny, table, false; what is left is background.
std::vector<RegionClass> classify_regions(const FrameTruth& truth, const PredictedRegions& predicted,
                                          const std::vector<Overlap>& overlaps,
                                          const std::vector<RegionMatch>& matches);

/// Whether a region takes part in Hoover's classes and the overlap and boundary scores.
inline bool is_compared(RegionClass c) {
  return c == RegionClass::matched || c == RegionClass::wrong;
}

/// Everything that the scores of regions need of one prediction: of its surfaces, or of its objects.
struct RegionComparison {
  const TruthLabels& truth;
  PredictedRegions predicted;
  std::vector<Overlap> overlaps;     ///< pixels that items (a) and regions (b) share
  std::vector<RegionMatch> matches;  ///< at IoU 0.5
  std::vector<RegionClass> classes;  ///< given these matches
  std::vector<Outline> outlines;     ///< of the regions
};
RegionComparison compare_regions(const FrameTruth& frame, const TruthLabels& truth,
                                 PredictedRegions predicted);

}  // namespace facet
