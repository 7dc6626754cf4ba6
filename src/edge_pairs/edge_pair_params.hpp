#pragma once

namespace facet {

/// The edge-pair baseline. Its source gives no thresholds: those of the smoothing and of creases are the ones
/// that served it best on the built-in scenes, the others are usual values or those of the gripper that the
/// pipeline has.
struct EdgePairParams {
  int smoothing_px = 5;         ///< side of the bilateral filter after the median, 1 = none, 1..31, odd
  float jump_ratio = 0.02f;     ///< least depth jump, relative to depth, 0..1
  float noise_sigmas = 4;       ///< and in deviations of the sensor's noise, 0..100
  float crease_deg = 40;        ///< least change of the gradient's direction, 0..180
  float gradient_sigmas = 3;    ///< directions of weaker gradients are noise, 0..100
  int depth_guard_px = 3;       ///< no crease this near a depth edge, 0..16
  int min_component_px = 15;    ///< smaller pieces of the edge map are dropped, 0..1000
  float line_tolerance_px = 2;  ///< an edge bends less than this along a segment, 0..100
  int min_length_px = 15;       ///< of a segment, 2..1000
  float merge_deg = 5;          ///< collinear segments: most angle between them, 0..90
  float merge_gap_px = 8;       ///< most gap, 0..1000
  float merge_offset_px = 2;    ///< most offset, 0..100
  int side_near_px = 3;         ///< the sides of an edge are looked at from here, 1..50
  int side_far_px = 6;          ///< to here, 1..50
  float convex_deg = 10;        ///< creases that turn by less are not sure to be convex, 0..180
  float friction = 0.5f;        ///< Coulomb coefficient of the fingers, 0..10
  float finger_width_mm = 15;   ///< least overlap of a pair, and room outside it, 1..1000
  float max_opening_mm = 100;   ///< of the jaw, 0..10000
};

}  // namespace facet
