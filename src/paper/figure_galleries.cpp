#include <fmt/format.h>

#include "file/file_bytes.hpp"
#include "overlay/palette.hpp"
#include "overlay/pose_panel.hpp"
#include "paper/evaluated_frame.hpp"
#include "paper/point_cloud.hpp"

namespace facet {
namespace {

/// Pairs of scene and surfaces, two pairs to a row.
cv::Mat gallery_of(const std::pair<Experiment, Plan>& planned, const std::string& dataset, std::size_t most) {
  std::vector<std::vector<cv::Mat>> rows;
  std::size_t count = 0;
  for (const PlannedDataset& data : planned.second.datasets)
    if (data.spec.name == dataset) count = std::min(most, data.frames.size());
  for (std::size_t i = 0; i < count; ++i) {
    const EvaluatedFrame frame = evaluate(planned, dataset, i, "default");
    if (rows.empty() || rows.back().size() == 4) rows.emplace_back();
    rows.back().push_back(color_panel(frame, frame.frame.frame.id));
    rows.back().push_back(surfaces_panel(frame, frame.caption("found")));
  }
  return panel_grid(rows);
}

}  // namespace

Reproduced reproduce_figure10(Reproduction& r) {
  const EvaluatedFrame frame = evaluate(r.plan("figures"), "scenes", 0, "default");
  const Prediction& prediction = frame.frame.prediction;
  const PoseCloud cloud = pose_cloud(frame.frame.frame, prediction);
  write_file_atomically(r.folder() / "figures/figure10.ply", to_ply(cloud));
  const cv::Mat picture = panel_grid(
      {{color_panel(frame, "Scene"),
        with_title(draw_poses(frame.frame.frame, prediction, surface_colors(prediction.labels)), "Contours",
                   {{"x", axis_colors[0]}, {"y", axis_colors[1]}, {"z", axis_colors[2]}}),
        with_title(draw_cloud(cloud, {640, 480}, 28, 12), "Point cloud with poses, turned")}});
  Reproduced result;
  result.section.title = "Figure 10";
  result.section.paragraphs = {
      "Poses of surfaces: x red, y green, z (the normal towards the camera) blue. figures/figure10.ply holds "
      "the "
      "point cloud with the axes as lines, for any viewer."};
  result.section.pictures = {r.save_picture("figure10", picture, "Figure 10: surface poses")};
  return result;
}

Reproduced reproduce_figure13(Reproduction& r) {
  Reproduced result;
  result.section.title = "Figure 13";
  if (r.has_data("osd"))
    result.section.pictures.push_back(
        r.save_picture("figure13_osd", gallery_of(r.plan("figures_osd"), "osd", 8),
                       "Figure 13: frames of OSD, surfaces in distinct colours"));
  result.section.pictures.push_back(
      r.save_picture("figure13", gallery_of(r.plan("figures"), "complex", 6),
                     "Figure 13: cluttered built-in scenes as a Kinect v1 sees them"));
  if (result.section.pictures.size() == 1)
    result.section.paragraphs = {"OSD is not below the data root: built-in scenes stand in."};
  return result;
}

Reproduced reproduce_figure14(Reproduction& r) {
  Reproduced result;
  result.section.title = "Figure 14";
  if (r.has_data("azure_frame"))
    result.section.pictures.push_back(
        r.save_picture("figure14_real", gallery_of(r.plan("figures_azure"), "azure", 4),
                       "Figure 14: a real frame of an Azure Kinect, mapped to its colour camera"));
  result.section.pictures.push_back(
      r.save_picture("figure14", gallery_of(r.plan("figures"), "azure", 6),
                     "Figure 14: built-in scenes as an Azure Kinect sees them"));
  return result;
}

}  // namespace facet
