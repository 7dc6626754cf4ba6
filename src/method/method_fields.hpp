#pragma once

#include "method/method_spec.hpp"
#include "pipeline/params_fields.hpp"

namespace facet {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<ProgramCall>{"frame", "batch"};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<RgbdNormals>{"fals", "linemod", "sri"};

// The parameters of methods that are not the pipeline, as visit_fields() lists those of the pipeline. They
// drive the reader, --set, the range checks and the method cards.

template <class Params, class Visitor>
void visit_external_fields(Params& p, Visitor&& visit) {
  visit("command", p.command,
        FieldInfo{"", 0, 0, "for /bin/sh, with {depth}, {color}, {intrinsics} and {out} in it"});
  visit("per", p.per, FieldInfo{"", 0, 0, "a run per frame, or per data set: then they are folders"});
  visit("timeout_s", p.timeout_s, FieldInfo{"s", 0.01, 86400, "a longer run is killed"});
  visit("depth_unit_mm", p.depth_unit_mm,
        FieldInfo{"mm", 0.01, 100, "what 1 means in the depth images that it is given"});
}

template <class Params, class Visitor>
void visit_stored_fields(Params& p, Visitor&& visit) {
  visit("poses", p.poses, FieldInfo{"", 0, 0, "a CSV of poses in the folder, as BOP has them"});
  visit("instances", p.instances, FieldInfo{"", 0, 0, "a JSON of COCO instances, for label images"});
  visit("frame_id", p.frame_id, FieldInfo{"", 0, 0, "the frame that {scene_id} and {im_id} of these name"});
}

template <class Params, class Visitor>
void visit_edge_pair_fields(Params& p, Visitor&& visit) {
  visit("smoothing_px", p.smoothing_px,
        FieldInfo{"px", 1, 31, "bilateral filter after the 3x3 median, 1 = none", true});
  visit("jump_ratio", p.jump_ratio, FieldInfo{"m/m", 0, 1, "least depth jump, relative to depth"});
  visit("noise_sigmas", p.noise_sigmas, FieldInfo{"sigma", 0, 100, "least depth jump in noise deviations"});
  visit("crease_deg", p.crease_deg,
        FieldInfo{"deg", 0, 180, "least change of the direction of the depth gradient"});
  visit("gradient_sigmas", p.gradient_sigmas,
        FieldInfo{"sigma", 0, 100, "directions of weaker gradients are noise"});
  visit("depth_guard_px", p.depth_guard_px, FieldInfo{"px", 0, 16, "no crease this near a depth edge"});
  visit("min_component_px", p.min_component_px,
        FieldInfo{"px", 0, 1000, "smaller pieces of edge are dropped"});
  visit("line_tolerance_px", p.line_tolerance_px, FieldInfo{"px", 0, 100, "most that a segment bends"});
  visit("min_length_px", p.min_length_px, FieldInfo{"px", 2, 1000, "least length of a segment"});
  visit("merge_deg", p.merge_deg, FieldInfo{"deg", 0, 90, "collinear segments: most angle between them"});
  visit("merge_gap_px", p.merge_gap_px, FieldInfo{"px", 0, 1000, "collinear segments: most gap"});
  visit("merge_offset_px", p.merge_offset_px, FieldInfo{"px", 0, 100, "collinear segments: most offset"});
  visit("side_near_px", p.side_near_px, FieldInfo{"px", 1, 50, "the sides of an edge are read from here"});
  visit("side_far_px", p.side_far_px, FieldInfo{"px", 1, 50, "to here"});
  visit("convex_deg", p.convex_deg, FieldInfo{"deg", 0, 180, "creases that turn by less are not sure"});
  visit("friction", p.friction, FieldInfo{"", 0, 10, "Coulomb coefficient of the fingers"});
  visit("finger_width_mm", p.finger_width_mm,
        FieldInfo{"mm", 1, 1000, "least overlap of a pair, and room needed outside it"});
  visit("max_opening_mm", p.max_opening_mm, FieldInfo{"mm", 0, 10000, "widest the jaw opens"});
}

template <class Params, class Visitor>
void visit_rgbd_fields(Params& p, Visitor&& visit) {
  visit("normals", p.normals, FieldInfo{"", 0, 0, "method of cv::rgbd::RgbdNormals"});
  visit("normal_window_px", p.normal_window_px, FieldInfo{"px", 1, 7, "window of the normals", true});
  visit("block_px", p.block_px, FieldInfo{"px", 4, 200, "planes grow from blocks of that side"});
  visit("min_area_px", p.min_area_px, FieldInfo{"px", 1, 1000000, "least area"});
  visit("distance_mm", p.distance_mm, FieldInfo{"mm", 0, 1000, "most distance of a pixel to its plane"});
  visit("error_per_m", p.error_per_m, FieldInfo{"1/m", 0, 1, "and the sensor's error, by depth squared"});
}

template <class Params, class Visitor>
void visit_pcl_fields(Params& p, Visitor&& visit) {
  visit("smoothing_px", p.smoothing_px, FieldInfo{"px", 1, 100, "smoothing of the normals"});
  visit("max_depth_change", p.max_depth_change,
        FieldInfo{"m/m", 0, 1, "normals do not reach over larger steps, relative to depth"});
  visit("min_inliers", p.min_inliers, FieldInfo{"px", 1, 1000000, "least area"});
  visit("angular_deg", p.angular_deg, FieldInfo{"deg", 0, 90, "most angle between normals of one plane"});
  visit("distance_mm", p.distance_mm, FieldInfo{"mm", 0, 1000, "most distance of a pixel to its plane"});
  visit("refine", p.refine, FieldInfo{"", 0, 0, "planes take in pixels at their borders"});
  visit("depth_jump", p.depth_jump, FieldInfo{"m/m", 0, 1, "edges: least step, relative to depth"});
}

/// The parameters of the method's own kind.
template <class Spec, class Visitor>
void visit_method_fields(Spec& spec, Visitor&& visit) {
  if (spec.kind == "pipeline") visit_fields(spec.params, visit);
  if (spec.kind == "predictions") visit_stored_fields(spec.stored, visit);
  if (spec.kind == "external") visit_external_fields(spec.external, visit);
  if (spec.kind == "edge_pairs") visit_edge_pair_fields(spec.edge_pairs, visit);
  if (spec.kind == "opencv_rgbd") visit_rgbd_fields(spec.rgbd, visit);
  if (spec.kind == "pcl_planes") visit_pcl_fields(spec.pcl, visit);
}

}  // namespace facet
