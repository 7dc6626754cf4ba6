#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "prediction/prediction.hpp"

namespace facet {

struct ColoredPoint {
  Vec3 p_m;  ///< camera frame
  std::array<std::uint8_t, 3> rgb{};
};

/// A frame's points in the colours of their surfaces (others in grey), and the axes of every pose as lines
/// from its origin: points[axes[i][0]] to points[axes[i][1]], `axis_length_m` long; x red, y green, z blue.
struct PoseCloud {
  std::vector<ColoredPoint> points;
  std::vector<std::array<int, 2>> axes;
};
PoseCloud pose_cloud(const Frame& frame, const Prediction& prediction, float axis_length_m = 0.04f);

/// PLY 1.0, ASCII, with the elements vertex (x y z red green blue) and edge (vertex1 vertex2).
std::string to_ply(const PoseCloud& cloud);

/// The cloud seen from beside the camera: turned about the vertical through its middle by `yaw_deg` and about
/// the horizontal by `pitch_deg`.
cv::Mat draw_cloud(const PoseCloud& cloud, cv::Size size, double yaw_deg, double pitch_deg);

}  // namespace facet
