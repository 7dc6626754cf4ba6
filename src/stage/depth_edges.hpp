#pragma once

namespace facet {

enum class DepthEdgeMode {
  jump,   ///< slope-corrected jump to a neighbour, on the nearer side
  canny,  ///< the paper: Canny on the magnitude of the depth gradient
};

struct DepthEdgeParams {
  DepthEdgeMode mode = DepthEdgeMode::jump;
  float jump_ratio = 0.015f;   ///< jump: least jump relative to depth [m/m], 0..1
  float noise_sigmas = 4.0f;  ///< jump: least jump in standard deviations of the sensor noise, 0..100
  float high_per_px = 0.010f;  ///< canny: upper threshold, relative depth change per pixel [1/px], 0..10
  float low_per_px = 0.005f;   ///< canny: lower threshold [1/px], 0..10
  bool relocate = true;        ///< canny: move edge pixels to the occluding (nearer) side
};

}  // namespace facet
