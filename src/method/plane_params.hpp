#pragma once

namespace facet {

enum class RgbdNormals { fals, linemod, sri };

/// OpenCV's plane finder, cv::rgbd::RgbdPlane, on its normals. Defaults are the library's, but for what marks
/// the smallest surface: that is what a truth surface must have to count.
struct RgbdPlaneParams {
  RgbdNormals normals = RgbdNormals::fals;
  int normal_window_px = 5;  ///< side of the window of the normals, 1..7, odd
  int block_px = 40;         ///< planes grow from blocks of that side, 4..200
  int min_area_px = 1600;    ///< 1..1000000
  float distance_mm = 10;    ///< of a pixel to its plane, 0..1000
  float error_per_m =
      0.0075f;  ///< the sensor's error by depth squared, as the library gives for a Kinect [1/m], 0..1
};

/// PCL's organized multi-plane segmentation on integral-image normals. Defaults are the library's.
struct PclPlaneParams {
  float smoothing_px = 10;         ///< of the normals, 1..100
  float max_depth_change = 0.02f;  ///< normals do not reach over larger steps, relative to depth, 0..1
  int min_inliers = 1000;          ///< px, 1..1000000
  float angular_deg = 3;           ///< between normals of one plane, 0..90
  float distance_mm = 20;          ///< of a pixel to its plane, at 1 m, 0..1000
  bool refine = true;              ///< planes take in pixels at their borders
  float depth_jump = 0.02f;        ///< organized edges: least step, relative to depth, 0..1
};

}  // namespace facet
