#pragma once

#include "core/edge_code.hpp"

namespace facet {

/// What became of one surface of the truth.
struct SurfaceOutcome {
  int number = 0;  ///< of the annotation
  int object = 0;
  int area_px = 0;
  bool graspable = false, curved = false;
  int region = 0;  ///< lowest label of the region that was found for it at IoU 0.5; 0 = none
  double iou = 0;  ///< with that region
};

/// What became of one edge of the truth.
struct EdgeOutcome {
  int number = 0;  ///< of the annotation
  int object = 0;
  EdgeKind kind = EdgeKind::none;
  bool graspable = false;
  int samples = 0;       ///< one per pixel of its length
  int hit_6px = 0;       ///< samples with a pixel of its kind near, at the tolerance named 6px
  int labelled_6px = 0;  ///< of these, with the graspable label right
  bool detected_6px = false;
};

}  // namespace facet
