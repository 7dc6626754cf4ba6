#pragma once

#include <string>

#include "synth/frame_plan.hpp"
#include "synth/scene_truth.hpp"
#include "truth/true_pose.hpp"
#include "truth/truth.hpp"

namespace facet {

/// The truth of a rendered view in the form that annotations of real frames have: outlines of the visible
/// faces, edges, the table top. Faces and edges are numbered from 1 in the order of `scene`.
Truth truth_of(const SceneTruth& scene, const Rendering& exact);

/// Planes and centroids of the faces, numbered as in truth_of().
std::vector<TruePose> true_poses(const SceneTruth& scene);

/// What an annotation cannot hold, as JSON: camera pose, poses of the objects, and per face the plane,
/// centroid, visible area and hidden share. Camera frame unless the name says world; metres.
std::string geometry_text(const SceneTruth& scene, const PlannedPicture& picture);

}  // namespace facet
