#pragma once

#include "score/region_match.hpp"
#include "score/tally.hpp"

namespace facet {

/// Detection at one IoU threshold (Kirillov et al. 2019 for PQ).
struct DetectionScore {
  int truth = 0;                                         ///< surfaces that count
  int detected = 0;                                      ///< matched with IoU >= threshold
  int wrong = 0;                                         ///< false regions
  double iou_total = 0;                                  ///< of the matches
  int table = 0, background = 0, ignored = 0, tiny = 0;  ///< regions that are reported but not false

  Tally recall() const { return {detected, truth}; }
  Tally precision() const { return {detected, detected + wrong}; }
};

DetectionScore score_detection(const TruthLabels& truth, const std::vector<RegionMatch>& matches,
                               const std::vector<RegionClass>& classes);

}  // namespace facet
