#pragma once

#include "score/region_match.hpp"
#include "score/tally.hpp"

namespace facet {

/// Errors of the pose of a flat surface that was detected.
struct PoseError {
  int surface = 0;          ///< TruthSurface::number
  double normal_deg = 0;    ///< angle between the normals
  double offset_m = 0;      ///< of the centre along the true normal
  double lateral_m = 0;     ///< of the centre in the true plane
  double rotation_deg = 0;  ///< angle of the rotation between the two poses
};

/// Poses against exact truth. Flat surfaces that count and whose truth is known make up every n; one that is
/// not detected at IoU 0.5, or without a valid pose, fails. Success is a rotation of at most 5 (10) degrees
/// and a centre at most 5 (10) mm off.
struct PoseScore {
  Tally success_5, success_10;
  double auc_total = 0;  ///< sum over the n surfaces of the area under success against threshold, 0 ... 10
                         ///< deg and mm, 0..1 each
  std::vector<PoseError> errors{};
  std::vector<double> curved_centre_m{};  ///< distance of the centres, of detected curved surfaces
};

/// `comparison` is that of surfaces. Of the predicted surfaces that make up a region, the largest with a
/// valid pose is taken.
PoseScore score_poses(const FrameTruth& frame, const RegionComparison& comparison,
                      const Prediction& prediction);

/// Errors of one pose.
PoseError pose_error(const TruePose& truth, const SurfacePose& estimate);

}  // namespace facet
