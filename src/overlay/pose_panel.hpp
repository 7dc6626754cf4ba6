#pragma once

#include <map>

#include "overlay/panel.hpp"

namespace facet {

/// Colours [BGR] of the axes x, y, z of a pose.
inline const std::array<cv::Scalar, 3> axis_colors{cv::Scalar(50, 50, 235), cv::Scalar(60, 200, 50),
                                                   cv::Scalar(255, 110, 40)};

/// Colour [BGR] of the contacts of a grasp and the line between them.
inline const cv::Scalar grasp_color{40, 40, 40};

/// The axes x, y, z of a unit quaternion: the columns of its rotation matrix.
std::array<Vec3, 3> pose_axes(const std::array<float, 4>& quaternion_wxyz);

/// Contours in the colours of their surfaces, with the projected axes of every pose: x red, y green, z blue
/// (the normal, towards the camera). Their length is a share of the surface's size, the same for the three in
/// space. Of every surface's grasps the best one.
cv::Mat draw_poses(const Frame& frame, const Prediction& prediction, const std::map<int, cv::Scalar>& colors);

}  // namespace facet
