#pragma once

namespace facet {

/// What a method yields.
struct PredictedParts {
  bool regions = true;  ///< labels; without, every label is 0
  bool edges = false, poses = false, grasps = false;
};

}  // namespace facet
