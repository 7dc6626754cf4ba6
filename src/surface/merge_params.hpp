#pragma once

namespace facet {

/// When a border between two regions is a crease: the patches fitted to both sides must differ where they
/// meet, by more than a smooth surface's would and more than their noise explains.
struct MergeParams {
  /// Least angle between the patches [deg], 0..180.
  float crease_deg = 25;
  /// Least step between the patches, relative to depth [m/m], 0..1: a third of the least jump of a depth
  /// edge.
  float step_ratio = 0.005f;
  float fit_sigmas = 3;        ///< least difference in deviations of the fits, 0..100
  float curve_radius_mm = 40;  ///< radius of usual curved surfaces [mm], 0..100000; 0 = patches are planes
  float flat_deg = 45;         ///< borders that turn by less are judged first [deg], 0..180
  /// Farthest that a border moves to where the patches meet [px], 0..16: strengths are known to within the
  /// window of the normals.
  int border_moves_px = 4;
};

}  // namespace facet
