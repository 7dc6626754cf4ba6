#pragma once

#include <array>
#include <string_view>

namespace facet {

/// The timed stages of the pipeline, in order of execution.
enum class StageId {
  temporal,
  fill,
  wiener,
  gradient,
  depth_strength,
  depth_canny,
  crease_strength,
  crease_canny,
  morphology,
  labelling,
  support,
  contours,
  validation,
  pose,
  grasps,
  objects,
};
inline constexpr int stage_count = 16;

struct StageName {
  StageId id;
  std::string_view key;     ///< in files: timing/stages.csv, benchmarks
  std::string_view column;  ///< column of the paper's Table 3 that the stage belongs to
};

/// Table 3 of the paper has one Canny column although Canny runs twice, and no column for the temporal
/// average, the support, the contour separation, the grasps and the objects; ours splits the first and adds
/// the others.
inline constexpr std::array<StageName, stage_count> stage_names{{
    {StageId::temporal, "temporal", "Temporal"},
    {StageId::fill, "fill", "Fill"},
    {StageId::wiener, "wiener", "Wiener"},
    {StageId::gradient, "gradient", "Sobel"},
    {StageId::depth_strength, "depth_strength", "DD"},
    {StageId::depth_canny, "depth_canny", "Canny DD"},
    {StageId::crease_strength, "crease_strength", "CD"},
    {StageId::crease_canny, "crease_canny", "Canny CD"},
    {StageId::morphology, "morphology", "Morphology"},
    {StageId::labelling, "labelling", "Labelling"},
    {StageId::support, "support", "Support"},
    {StageId::contours, "contours", "Contours"},
    {StageId::validation, "validation", "Validation"},
    {StageId::pose, "pose", "Pose"},
    {StageId::grasps, "grasps", "Grasps"},
    {StageId::objects, "objects", "Objects"},
}};

constexpr int index_of(StageId id) {
  return static_cast<int>(id);
}

}  // namespace facet
