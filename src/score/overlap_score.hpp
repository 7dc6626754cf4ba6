#pragma once

#include "score/region_match.hpp"

namespace facet {

/// Overlap and boundary scores of UOIS and OCID (Xie et al. 2020; Suchi et al. 2019), as counts of pixels.
struct OverlapScore {
  int common_px = 0;     ///< of assigned pairs
  int predicted_px = 0;  ///< of the compared regions
  int truth_px = 0;
  int boundary_predicted_hit = 0;  ///< outline pixels of assigned regions near their item's outline
  int boundary_predicted = 0;
  int boundary_truth_hit = 0;
  int boundary_truth = 0;
  int found_75 = 0;   ///< assigned pairs with F > 0.75
  int truth = 0;      ///< items
  int predicted = 0;  ///< compared regions
};

/// Assigns compared regions to items one to one at the largest total F; pairs without a common pixel are not
/// assigned.
OverlapScore score_overlap(const RegionComparison& comparison);

/// Precision, recall and F with the edge cases of the protocol: nothing predicted gives P = 1, nothing to
/// find R = 1; F is 1 where there is neither, 0 where one is missing.
struct PrecisionRecall {
  double precision = 0, recall = 0, f = 0;
};
PrecisionRecall precision_recall(double predicted_hit, double predicted, double truth_hit, double truth);

}  // namespace facet
