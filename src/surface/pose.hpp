#pragma once

namespace facet {

enum class PoseCentre {
  inliers,  ///< mean of the inliers, projected on the plane
  contour,  ///< the paper: mean of the contour's pixels, lifted by the depth found there
};

struct PoseParams {
  bool enabled = true;
  PoseCentre centre = PoseCentre::inliers;
  int iterations = 128;          ///< most RANSAC hypotheses, 1..10000
  int max_points = 1024;         ///< size of the consensus set, 16..100000
  float inlier_sigmas = 3.0f;    ///< inlier threshold in standard deviations of the sensor noise, 0..100
  float min_inlier_mm = 4.0f;    ///< and at least this [mm], 0..1000
  float curved_below_share = 0.8f;  ///< a surface with a smaller inlier share is flagged as curved, 0..1
};

}  // namespace facet
