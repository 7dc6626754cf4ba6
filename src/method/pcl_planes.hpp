#pragma once

#include <memory>
#include <string_view>

#include "method/registry.hpp"

namespace facet {

/// Planes by PCL: normals from integral images, organized multi-plane segmentation (Trevor et al., 2013) with
/// its refinement, and organized edges (Choi et al., IROS 2013) for the edge image: occluding ones as depth
/// edges, those of high curvature as creases, whose sign follows from the normals on both sides. PCL does not
/// tell which edges a finger could reach: occluding and convex ones are labelled so. No grasps.
std::unique_ptr<Method> make_pcl_planes(const MethodSpec& spec, const MethodContext& context);

/// Regions, edges and poses.
std::optional<PredictedParts> yields_pcl_planes(const MethodSpec& spec);

/// Why this build cannot make one, and what to do; empty where it can.
std::string_view what_pcl_planes_lack();

}  // namespace facet
