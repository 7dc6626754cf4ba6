#pragma once

#include <limits>
#include <string_view>

#include "pipeline/enum_names.hpp"
#include "pipeline/params.hpp"

namespace facet {

/// What is known of one parameter beside its type and value.
struct FieldInfo {
  std::string_view unit;  ///< "" for a pure number or a switch
  double min = 0;         ///< inclusive; ignored for switches and enumerations
  double max = 0;
  std::string_view doc;  ///< one line
  bool odd = false;      ///< integers: only odd values
};

/// THE list of parameters: calls visit(key, member, info) for each. It drives the YAML reader, --set, the
/// range checks and the generated documentation; a new parameter is added here and in its stage, nowhere
/// else. Members are bool, int, float, or an enumeration with names in enum_names.hpp.
template <class Params, class Visitor>
void visit_fields(Params& p, Visitor&& visit) {
  visit("sensor", p.sensor, FieldInfo{"", 0, 0, "noise model; automatic = what the data set declares"});

  visit("temporal.enabled", p.temporal.enabled,
        FieldInfo{"", 0, 0, "average over past frames (sequences only)"});
  visit("temporal.mode", p.temporal.mode, FieldInfo{"", 0, 0, "mean (eq. 3) or robust mean"});
  visit("temporal.frames", p.temporal.frames,
        FieldInfo{"frames", 1, 16, "window, the current frame included"});
  visit("temporal.max_gap_s", p.temporal.max_gap_s,
        FieldInfo{"s", 0, 3600, "a longer gap in time ends a window; 0 = none does"});
  visit("temporal.max_motion_sigmas", p.temporal.max_motion_sigmas,
        FieldInfo{"sigma", 0, 100,
                  "motion of the camera that changes depths by more ends a window; 0 = none does"});

  visit("outline.fattening_px", p.outline.fattening_px,
        FieldInfo{"px", -1, 8, "near outlines are trimmed by this much; -1 = by what the sensor adds"});
  visit("outline.jump_ratio", p.outline.jump_ratio,
        FieldInfo{"m/m", 0, 1, "least jump at an outline, relative to depth"});

  visit("fill.enabled", p.fill.enabled, FieldInfo{"", 0, 0, "fill missing depth (Algorithm 1)"});
  visit("fill.prefer", p.fill.prefer,
        FieldInfo{"", 0, 0, "far = shadows are filled from their far side only"});
  visit("fill.max_passes", p.fill.max_passes,
        FieldInfo{"passes", 0, 512, "one pixel is filled per pass and side"});
  visit("fill.max_hole_px", p.fill.max_hole_px,
        FieldInfo{"px", 0, 4096, "widest hole that is filled, 0 = any"});
  visit("fill.rim_jump", p.fill.rim_jump,
        FieldInfo{"m/m", 0, 1, "relative jump across a hole that makes a rim"});
  visit("fill.rim_search_px", p.fill.rim_search_px, FieldInfo{"px", 1, 256, "how far across a hole to look"});

  visit("wiener.enabled", p.wiener.enabled, FieldInfo{"", 0, 0, "adaptive Wiener filter (eq. 2)"});
  visit("wiener.gain", p.wiener.gain, FieldInfo{"", 0, 0, "paper = eq. 2 as printed, lim = Lim 1990"});
  visit("wiener.noise", p.wiener.noise, FieldInfo{"", 0, 0, "sensor model, or mean of the local variances"});
  visit("wiener.window_px", p.wiener.window_px, FieldInfo{"px", 3, 7, "side of the window", true});
  visit("wiener.detrend", p.wiener.detrend, FieldInfo{"", 0, 0, "variance about the local slope"});

  visit("gradient.operator", p.gradient.op, FieldInfo{"", 0, 0, "Sobel or plain central differences"});

  visit("dd.mode", p.dd.mode, FieldInfo{"", 0, 0, "depth edges: jump test or the paper's Canny"});
  visit("dd.jump_ratio", p.dd.jump_ratio, FieldInfo{"m/m", 0, 1, "jump: least jump relative to depth"});
  visit("dd.noise_sigmas", p.dd.noise_sigmas,
        FieldInfo{"sigma", 0, 100, "jump: least jump in noise deviations"});
  visit("dd.high_per_px", p.dd.high_per_px,
        FieldInfo{"1/px", 0, 10, "canny: upper relative change per pixel"});
  visit("dd.low_per_px", p.dd.low_per_px, FieldInfo{"1/px", 0, 10, "canny: lower relative change per pixel"});
  visit("dd.relocate", p.dd.relocate, FieldInfo{"", 0, 0, "canny: move edges to the occluding side"});

  visit("cd.mode", p.cd.mode,
        FieldInfo{"", 0, 0, "creases: normals, paper (eq. 6) or gaussian (section 3.2)"});
  visit("cd.angle", p.cd.angle, FieldInfo{"", 0, 0, "paper: atan2, or atan as printed"});
  visit("cd.weighted", p.cd.weighted, FieldInfo{"", 0, 0, "paper: damp directions below their own noise"});
  visit("cd.radius_px", p.cd.radius_px, FieldInfo{"px", 1, 16, "normals: half side of the fit window"});
  visit("cd.closure", p.cd.closure, FieldInfo{"", 0, 0, "closed lines between basins, or the paper's Canny"});
  visit("cd.floor_deg", p.cd.floor_deg,
        FieldInfo{"deg", 0, 180, "basins: smaller changes are noise of the fits"});
  visit("cd.high_deg", p.cd.high_deg, FieldInfo{"deg", 0, 180, "upper threshold on the change of direction"});
  visit("cd.low_deg", p.cd.low_deg, FieldInfo{"deg", 0, 180, "lower threshold"});
  visit("cd.depth_guard_px", p.cd.depth_guard_px, FieldInfo{"px", 0, 16, "no crease this near a depth edge"});

  visit("merge.crease_deg", p.merge.crease_deg,
        FieldInfo{"deg", 0, 180, "basins: least angle between the patches of two surfaces that meet"});
  visit("merge.step_ratio", p.merge.step_ratio,
        FieldInfo{"m/m", 0, 1, "basins: least step between them, relative to depth"});
  visit("merge.fit_sigmas", p.merge.fit_sigmas,
        FieldInfo{"sigma", 0, 100, "basins: least difference in deviations of the fits"});
  visit("merge.curve_radius_mm", p.merge.curve_radius_mm,
        FieldInfo{"mm", 0, 100000, "basins: radius of usual curved surfaces; 0 = patches are planes"});
  visit("merge.flat_deg", p.merge.flat_deg,
        FieldInfo{"deg", 0, 180, "basins: borders that turn by less are judged first"});
  visit("merge.border_moves_px", p.merge.border_moves_px,
        FieldInfo{"px", 0, 16, "basins: farthest that a border moves to where the patches meet"});

  visit("convexity", p.edge_kind.convexity,
        FieldInfo{"", 0, 0, "signed test, or Table 1's hessian as printed"});
  visit("hessian_dead_band_per_m", p.edge_kind.hessian_dead_band_per_m,
        FieldInfo{"1/m", 0, 1000, "hessian: smaller curvature is undecided"});

  visit("morphology.mode", p.morphology.mode, FieldInfo{"", 0, 0, "none, bridge or paper (eqs 7-9)"});
  visit("morphology.bridge_px", p.morphology.bridge_px,
        FieldInfo{"px", 0, 5, "bridge: dilation before thinning"});
  visit("morphology.small_element_px", p.morphology.small_element_px,
        FieldInfo{"px", 3, 31, "paper: B2", true});
  visit("morphology.large_element_px", p.morphology.large_element_px,
        FieldInfo{"px", 3, 63, "paper: B1", true});

  visit("pruning.mode", p.pruning.mode, FieldInfo{"", 0, 0, "stability, gonzalez (eq. 10) or none"});
  visit("pruning.iterations", p.pruning.iterations,
        FieldInfo{"px", 0, 100, "gonzalez: longest spur removed"});

  visit("support.enabled", p.support.enabled,
        FieldInfo{"", 0, 0, "join the pieces of what the objects stand on (contours: regions)"});
  visit("support.max_tilt_deg", p.support.max_tilt_deg,
        FieldInfo{"deg", 0, 180, "most that it leans from the camera's up"});
  visit("support.flatness_mm", p.support.flatness_mm,
        FieldInfo{"mm", 0, 1000, "unevenness of support and sensor at 1 m; grows with depth squared"});
  visit("support.noise_sigmas", p.support.noise_sigmas,
        FieldInfo{"sigma", 0, 100, "allowance for the noise of a piece's plane"});

  visit("contours", p.contours.mode, FieldInfo{"", 0, 0, "outlines of regions, or of the edge map (paper)"});

  visit("validation.enabled", p.validation.enabled,
        FieldInfo{"", 0, 0, "drop regions that cannot be surfaces"});
  visit("validation.min_area_px", p.validation.min_area_px, FieldInfo{"px", 0, 1000000, "least area"});
  visit("validation.min_size_mm", p.validation.min_size_mm,
        FieldInfo{"mm", 0, 1000, "least side at its depth"});
  visit("validation.min_width_px", p.validation.min_width_px, FieldInfo{"px", 0, 1000, "least mean width"});
  visit("validation.min_valid_share", p.validation.min_valid_share,
        FieldInfo{"", 0, 1, "least share of pixels with measured depth"});

  visit("pose.enabled", p.pose.enabled, FieldInfo{"", 0, 0, "fit plane and 6-DOF pose to every surface"});
  visit("pose.centre", p.pose.centre, FieldInfo{"", 0, 0, "mean of the inliers, or of the contour (paper)"});
  visit("pose.iterations", p.pose.iterations, FieldInfo{"", 1, 10000, "most RANSAC hypotheses"});
  visit("pose.max_points", p.pose.max_points, FieldInfo{"points", 16, 100000, "size of the consensus set"});
  visit("pose.inlier_sigmas", p.pose.inlier_sigmas, FieldInfo{"sigma", 0, 100, "inlier threshold"});
  visit("pose.min_inlier_mm", p.pose.min_inlier_mm, FieldInfo{"mm", 0, 1000, "inlier threshold, at least"});
  visit("pose.curved_below_share", p.pose.curved_below_share,
        FieldInfo{"", 0, 1, "a smaller inlier share means a curved surface"});

  visit("grasp.enabled", p.grasp.enabled, FieldInfo{"", 0, 0, "find force-closure grasps on every surface"});
  visit("grasp.friction", p.grasp.friction, FieldInfo{"", 0, 10, "Coulomb coefficient of the fingers"});
  visit("grasp.finger_width_mm", p.grasp.finger_width_mm,
        FieldInfo{"mm", 1, 1000, "least overlap of two edges, and room needed outside them"});
  visit("grasp.max_opening_mm", p.grasp.max_opening_mm, FieldInfo{"mm", 0, 10000, "widest the jaw opens"});
  visit("grasp.min_opening_mm", p.grasp.min_opening_mm,
        FieldInfo{"mm", 0, 10000, "narrowest that is grasped"});
  visit("grasp.line_tolerance_px", p.grasp.line_tolerance_px,
        FieldInfo{"px", 0, 100, "most that a straight piece of an edge bends"});
  visit("grasp.min_edge_px", p.grasp.min_edge_px,
        FieldInfo{"px", 0, 1000, "shorter pieces have no sure direction"});
  visit("grasp.clearance_mm", p.grasp.clearance_mm,
        FieldInfo{"mm", 0, 1000, "what stands out of the surface by more blocks a finger"});
  visit("grasp.most_per_surface", p.grasp.most_per_surface,
        FieldInfo{"grasps", 1, 100, "the best ones are kept"});

  visit("objects.enabled", p.objects.enabled, FieldInfo{"", 0, 0, "group surfaces into objects"});
  visit("objects.min_convex_share", p.objects.min_convex_share,
        FieldInfo{"", 0, 1, "least share of convex among the creases between two faces of an object"});
  visit("objects.min_crease_share", p.objects.min_crease_share,
        FieldInfo{"", 0, 1, "least share of creases along their border; the rest is depth edges"});
  visit("objects.hollow", p.objects.hollow,
        FieldInfo{"", 0, 0, "a hollow inside belongs to the curved outside that hides part of it"});
  visit("objects.max_size_mm", p.objects.max_size_mm,
        FieldInfo{"mm", 0, 100000, "what leaves the image and is larger than its square is no object"});
}

}  // namespace facet
