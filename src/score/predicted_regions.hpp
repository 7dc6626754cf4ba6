#pragma once

#include <vector>

#include "prediction/prediction.hpp"
#include "score/frame_truth.hpp"
#include "score/overlap_counts.hpp"

namespace facet {

/// A region of the prediction as it is scored.
struct PredictedRegion {
  std::vector<int> ids{};  ///< labels of the prediction that make it up, ascending
  int area_px = 0;         ///< without void pixels
  int void_px = 0;
  int support_px = 0;  ///< of its area on support
};

struct PredictedRegions {
  Image<std::uint16_t> map{};              ///< index in `regions` + 1, 0 = none; void pixels removed
  std::vector<PredictedRegion> regions{};  ///< by their lowest id
};

/// Throws Error{data} naming both sizes where labels or edges have another size than the truth.
void require_size_of_truth(const FrameTruth& truth, const Prediction& prediction);

/// The regions that surfaces are matched with. Where a truth surface has several parts of at least
/// counted_surface_px, cut apart by an occluder, the predicted regions whose IoU with one part exceeds 0.5
/// are joined.
PredictedRegions surface_regions(const FrameTruth& truth, const Prediction& prediction);

/// The regions that objects are compared with: the labels of one `Surface::object` joined, every other label
/// by itself.
PredictedRegions object_regions(const FrameTruth& truth, const Prediction& prediction);

/// Intersection over union from areas.
inline double overlap_share(int common_px, int area_a_px, int area_b_px) {
  return static_cast<double>(common_px) / (area_a_px + area_b_px - common_px);
}

}  // namespace facet
