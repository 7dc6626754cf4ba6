#pragma once

#include <memory>

#include "method/registry.hpp"

namespace facet {

/// OpenCV's plane finder: cv::rgbd::RgbdPlane on the points and normals of a frame as it stands, unfiltered.
/// Yields labels and the poses of planes; no edges, no grasps. Curved surfaces are what it makes of them.
std::unique_ptr<Method> make_opencv_rgbd(const MethodSpec& spec, const MethodContext& context);

/// Regions and poses.
std::optional<PredictedParts> yields_planes(const MethodSpec& spec);

}  // namespace facet
