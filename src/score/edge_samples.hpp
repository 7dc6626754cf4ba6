#pragma once

#include <limits>
#include <vector>

#include "score/frame_truth.hpp"
#include "score/offsets.hpp"

namespace facet {

/// What a prediction shows at a sample of a truth edge.
struct SampleHit {
  double same_kind_px =
      std::numeric_limits<double>::infinity();  ///< distance of the nearest pixel of the kind
  double any_kind_px = std::numeric_limits<double>::infinity();  ///< of the nearest edge pixel
  bool label_right = false;  ///< graspable label of the nearest of the kind, or of one as near
};

/// One entry per sample of the edge. Pixels farther than `reach_px` need not be found.
class SampleSearch {
 public:
  SampleSearch(const Image<std::uint8_t>& codes, double reach_px);
  std::vector<SampleHit> search(const ScoredEdge& edge) const;

 private:
  SampleHit search(ImagePoint sample, const ScoredEdge& edge) const;

  const Image<std::uint8_t>& codes_;
  std::vector<GridOffset> offsets_;
};

}  // namespace facet
