#pragma once

#include "score/frame_truth.hpp"

namespace facet {

/// How cluttered a frame is.
struct Clutter {
  int objects = 0;   ///< with a surface that counts; of the masks where surfaces are not annotated
  int surfaces = 0;  ///< that count
  /// Share of the samples of depth edges whose outer side is another object's surface within
  /// neighbourhood_px; 0 without depth edges. The outer side is the one with fewer pixels of the owner.
  double occluded_share = 0;
  int contacts =
      0;  ///< concave edges with half of their samples within neighbourhood_px of another's surface
};

/// Of the edges that count.
Clutter clutter_of(const FrameTruth& frame);

}  // namespace facet
