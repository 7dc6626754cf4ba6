#include "experiment/ablation_strips.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "experiment/run_directory.hpp"
#include "file/image_file.hpp"
#include "file/portable_name.hpp"
#include "overlay/strip.hpp"
#include "prediction/prediction_io.hpp"
#include "study/design_names.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

struct ShownMethod {
  std::string name, title;
};

/// "fill-wiener" of "paper.fill-wiener".
std::string variant_of(const std::string& method) {
  return method.substr(method.find('.') + 1);
}

/// Methods of every ablation in the order in which they are shown; the key is "DESIGN_BASE".
std::map<std::string, std::vector<ShownMethod>> shown_methods(const AblationPlan& ablation) {
  std::map<std::string, std::vector<ShownMethod>> shown;
  for (const AblationComparison& comparison : ablation.comparisons) {
    auto& methods = shown[fmt::format("{}_{}", enum_name(comparison.design), comparison.base)];
    const auto show = [&](const std::string& method, const std::string& title) {
      const auto is_shown = [&](const ShownMethod& m) { return m.name == method; };
      if (std::none_of(methods.begin(), methods.end(), is_shown)) methods.push_back({method, title});
    };
    const std::string& name = comparison.switch_name;
    // What stays the same from row to row comes first.
    const bool from_all = comparison.design == AblationDesign::leave_one_out;
    const bool adds = comparison.design == AblationDesign::cumulative;
    for (const auto& [with, without] : comparison.pairs) {
      if (from_all) show(with, "all");
      show(without, from_all ? "without " + name : adds ? "none" : variant_of(without));
      if (!from_all) show(with, adds ? "+ " + name : variant_of(with));
    }
  }
  return shown;
}

std::vector<StripStep> read_steps(const fs::path& predictions, const std::vector<ShownMethod>& methods,
                                  const fs::path& dataset, const std::string& frame) {
  std::vector<StripStep> steps;
  for (const auto& [method, title] : methods) {
    const fs::path stem = predictions / method / dataset / frame;
    if (!fs::exists(PredictionFiles(stem).labels)) return {};
    steps.push_back({title, read_prediction(stem)});
  }
  return steps;
}

}  // namespace

void write_ablation_strips(const AblationPlan& ablation, const Plan& plan, const fs::path& run) {
  for (const auto& [folder, methods] : shown_methods(ablation)) {
    if (methods.empty()) continue;
    for (const PlannedDataset& planned : plan.datasets) {
      for (const std::size_t index : planned.frames) {
        const std::string frame = portable_name(planned.data->frame_id(index));
        const auto steps = read_steps(run / "predictions", methods, planned.data->name(), frame);
        if (steps.empty()) continue;
        write_png_file(run / "strips" / folder / planned.data->name() / (frame + ".png"),
                       draw_strip(planned.data->load(index), steps), PngEffort::least_time);
      }
    }
  }
}

}  // namespace facet
