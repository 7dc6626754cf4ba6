#include "experiment/ablation_strips.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "experiment/run_directory.hpp"
#include "file/image_file.hpp"
#include "overlay/strip.hpp"
#include "prediction/prediction_io.hpp"
#include "study/design_names.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

/// Methods of every ablation in the order in which they are shown; the key is "DESIGN_BASE".
std::map<std::string, std::vector<std::string>> shown_methods(const AblationPlan& ablation) {
  std::map<std::string, std::vector<std::string>> shown;
  for (const AblationComparison& comparison : ablation.comparisons) {
    auto& methods = shown[fmt::format("{}_{}", enum_name(comparison.design), comparison.base)];
    const auto show = [&](const std::string& method) {
      if (std::find(methods.begin(), methods.end(), method) == methods.end()) methods.push_back(method);
    };
    // What stays the same from row to row comes first.
    const bool from_all = comparison.design == AblationDesign::leave_one_out;
    for (const auto& [with, without] : comparison.pairs) {
      show(from_all ? with : without);
      show(from_all ? without : with);
    }
  }
  return shown;
}

std::vector<StripStep> read_steps(const fs::path& predictions, const std::vector<std::string>& methods,
                                  const fs::path& dataset, const std::string& frame) {
  std::vector<StripStep> steps;
  for (const std::string& method : methods) {
    const fs::path stem = predictions / method / dataset / frame;
    if (!fs::exists(PredictionFiles(stem).labels)) return {};
    steps.push_back({method.substr(method.find('.') + 1), read_prediction(stem)});
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
        constexpr int fast = 1;
        write_png_file(run / "strips" / folder / planned.data->name() / (frame + ".png"),
                       draw_strip(planned.data->load(index), steps), fast);
      }
    }
  }
}

}  // namespace facet
