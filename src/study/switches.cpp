#include "study/switches.hpp"

#include <array>

#include "pipeline/gradient_use.hpp"
#include "pipeline/params_fields.hpp"

namespace facet {
namespace {

using P = PipelineParams;

std::string needs(bool holds, const char* what) {
  return holds ? std::string() : std::string("it needs ") + what;
}
std::string always(const P&) {
  return {};
}
std::string needs_gradient(const P& p) {
  return uses_gradient(p) ? std::string() : "no step uses the gradient";
}
std::string needs_temporal(const P& p) {
  return needs(p.temporal.enabled, "the temporal average");
}
std::string needs_fill(const P& p) {
  return needs(p.fill.enabled, "fill");
}
std::string needs_wiener(const P& p) {
  return needs(p.wiener.enabled, "the Wiener filter");
}
std::string needs_jumps_off(const P& p) {
  return needs(p.dd.mode == DepthEdgeMode::canny, "depth edges by Canny");
}
std::string needs_directions(const P& p) {
  return needs(p.cd.mode == CreaseMode::paper, "creases by the paper's eq. 6");
}
std::string needs_basins(const P& p) {
  return needs(p.cd.closure == CreaseClosure::basins, "closed basins");
}
std::string needs_normals(const P& p) {
  return needs(p.cd.mode == CreaseMode::normals, "creases by normals");
}
std::string needs_region_contours(const P& p) {
  return needs(p.contours.mode == ContourMode::regions, "outlines of regions");
}
std::string needs_fattening(const P& p) {
  return needs(fattening_px(p.outline, p.sensor) > 0, "a sensor that fattens near outlines");
}
std::string needs_pose(const P& p) {
  return needs(p.pose.enabled, "poses");
}

void turn_off_normals(P& p) {
  p.cd.mode = CreaseMode::paper;
  p.cd.closure = CreaseClosure::canny;  // basins are basins of the normals' change
}

constexpr std::array table{
    AblationSwitch{"temporal", "average over past frames (3.4.2)", [](P& p) { p.temporal.enabled = false; },
                   always, true},
    AblationSwitch{"fill", "fill of missing depth (3.4.3)", [](P& p) { p.fill.enabled = false; }, always},
    AblationSwitch{"wiener", "Wiener filter (3.4.1)", [](P& p) { p.wiener.enabled = false; }, always},
    AblationSwitch{"sobel", "Sobel's gradient; off: central differences",
                   [](P& p) { p.gradient.op = GradientOperator::central; }, needs_gradient},
    AblationSwitch{"relocation", "depth edges moved to the occluding side",
                   [](P& p) { p.dd.relocate = false; }, needs_jumps_off},
    AblationSwitch{"damping", "directions damped below their own noise", [](P& p) { p.cd.weighted = false; },
                   needs_directions},
    AblationSwitch{"morphology", "closing of gaps in edges (3.3)",
                   [](P& p) { p.morphology.mode = MorphologyMode::none; }, always},
    AblationSwitch{"pruning", "removal of spurs (4.2.2)", [](P& p) { p.pruning.mode = PruningMode::none; },
                   always},
    AblationSwitch{"validation", "drops regions that cannot be surfaces",
                   [](P& p) { p.validation.enabled = false; }, always},
    AblationSwitch{"robust_average", "robust mean over frames; off: eq. 3's mean",
                   [](P& p) { p.temporal.mode = TemporalMode::mean; }, needs_temporal, true},
    AblationSwitch{"far_fill", "holes filled from the far side; off: from the nearest",
                   [](P& p) { p.fill.prefer = FillPrefer::nearest; }, needs_fill},
    AblationSwitch{"lim_gain", "Lim's gain; off: eq. 2 as printed",
                   [](P& p) { p.wiener.gain = WienerGain::paper; }, needs_wiener},
    AblationSwitch{"sensor_noise", "noise of the sensor model; off: mean of the local variances",
                   [](P& p) { p.wiener.noise = WienerNoise::mean; }, needs_wiener},
    AblationSwitch{"detrend", "variance about the local slope; off: about the mean",
                   [](P& p) { p.wiener.detrend = false; }, needs_wiener},
    AblationSwitch{"jump", "depth edges by jumps; off: by Canny",
                   [](P& p) { p.dd.mode = DepthEdgeMode::canny; }, always},
    AblationSwitch{"normals", "closed creases by fitted normals; off: eq. 6 and Canny", turn_off_normals,
                   always},
    AblationSwitch{"basins", "creases closed by basins; off: Canny",
                   [](P& p) { p.cd.closure = CreaseClosure::canny; }, needs_normals},
    AblationSwitch{"patch_fit", "smooth curved surfaces stay whole; off: planes alone",
                   [](P& p) { p.merge.curve_radius_mm = 0; }, needs_basins},
    AblationSwitch{"border_moves", "borders moved to where the patches meet",
                   [](P& p) { p.merge.border_moves_px = 0; }, needs_basins},
    AblationSwitch{"outlines", "near outlines trimmed by what the sensor adds",
                   [](P& p) { p.outline.fattening_px = 0; }, needs_fattening},
    AblationSwitch{"signed_convexity", "signed convexity; off: Table 1's Hessian",
                   [](P& p) { p.edge_kind.convexity = Convexity::hessian; }, always},
    AblationSwitch{"no_morphology", "edges as they are; off: the paper's dilation and erosion (eqs 7-9)",
                   [](P& p) { p.morphology.mode = MorphologyMode::paper; }, always},
    AblationSwitch{"stability", "spurs pruned by stability; off: by eq. 10",
                   [](P& p) { p.pruning.mode = PruningMode::gonzalez; }, always},
    AblationSwitch{"region_contours", "outlines of regions; off: of the edge map",
                   [](P& p) { p.contours.mode = ContourMode::edge_map; }, always},
    AblationSwitch{"support", "pieces of the support joined", [](P& p) { p.support.enabled = false; },
                   needs_region_contours},
    AblationSwitch{"objects", "surfaces grouped into objects; off: every surface is one",
                   [](P& p) { p.objects.enabled = false; }, always},
    AblationSwitch{"inlier_centre", "pose at the mean of the inliers; off: of the contour",
                   [](P& p) { p.pose.centre = PoseCentre::contour; }, needs_pose},
};

}  // namespace

std::span<const AblationSwitch> ablation_switches() {
  return table;
}

const AblationSwitch* find_switch(std::string_view name) {
  for (const AblationSwitch& s : table)
    if (s.name == name) return &s;
  return nullptr;
}

bool same_params(const PipelineParams& a, const PipelineParams& b) {
  // Both lists are visited in the same order.
  std::vector<double> numbers;
  const auto as_number = [](const auto& value) { return static_cast<double>(value); };
  visit_fields(
      a, [&](std::string_view, const auto& value, const FieldInfo&) { numbers.push_back(as_number(value)); });
  bool same = true;
  std::size_t i = 0;
  visit_fields(b, [&](std::string_view, const auto& value, const FieldInfo&) {
    same = same && numbers[i++] == as_number(value);
  });
  return same;
}

}  // namespace facet
