#pragma once

#include "score/region_match.hpp"
#include "score/tally.hpp"

namespace facet {

/// Objects and surfaces that a robot could take, as the paper's Table 2 counts them. Objects: graspable ones;
/// surfaces: graspable ones that count.
struct GraspScore {
  Tally surfaces;              ///< detected at IoU 0.5
  Tally objects_grasp;         ///< the paper's rule: pose and a grasp on a detected graspable surface
  Tally objects_pose;          ///< without the condition on grasps
  Tally objects_all_surfaces;  ///< every counted surface of the object is detected
  Tally surfaces_by_grasp;     ///< a grasp between two of its graspable edges, with or without a region
  Tally objects_by_grasp;
};

/// `comparison` is that of surfaces. A contact is on an object within the tolerance of its mask or surfaces,
/// and on an edge within the tolerance of its line. The two contacts of a grasp lie on two different
/// graspable edges, short ones too, or on one that bends round and turns_back() between them.
GraspScore score_grasps(const FrameTruth& frame, const RegionComparison& comparison,
                        const Prediction& prediction);

/// Whether the edge runs back at one of the points: its directions there differ by more than a right angle,
/// and the points are more than two tolerances apart. So the outline of a ball opposes itself.
bool turns_back(const ScoredEdge& edge, ImagePoint p, ImagePoint q, double tolerance_px);

/// Finite, with a quaternion of length 1 (to 0.001).
bool is_valid_pose(const SurfacePose& pose);

/// The surfaces of the prediction that make up a region, largest first; labels without an entry are left out.
std::vector<const Surface*> surfaces_of(const PredictedRegion& region, const Prediction& prediction);

}  // namespace facet
