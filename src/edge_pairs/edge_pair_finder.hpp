#pragma once

#include "edge_pairs/edge_map.hpp"
#include "edge_pairs/pairs.hpp"

namespace facet {

/// The edge-pair baseline, in the manner of Jabalameli and Behal, Robotics 8(3):63, 2019: a reconstruction,
/// since neither its code nor its thresholds are public. Grasps from pairs of opposing edges of a single
/// depth image, without contours or regions. Keeps its memory between frames.
class EdgePairFinder {
 public:
  EdgePairFinder(const EdgePairParams& params, const DepthNoise& noise) : params_(params), noise_(noise) {}

  /// Fills `edges` and `grasps`, and sets every label to 0.
  void find(ImageView<const float> depth_m, const Camera& camera, Prediction& prediction);

 private:
  EdgePairParams params_;
  DepthNoise noise_;
  EdgeMap map_;
};

}  // namespace facet
