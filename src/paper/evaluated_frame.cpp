#include "paper/evaluated_frame.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "overlay/palette.hpp"
#include "overlay/surface_panel.hpp"

namespace facet {

std::string EvaluatedFrame::caption(const std::string& method) const {
  if (!score || !score->annotated.surfaces)
    return fmt::format("{}: {} regions", method, frame.prediction.surfaces.size());
  const DetectionScore& found = score->surfaces_50;
  return fmt::format("{}: {} of {} surfaces, {} false", method, found.detected, found.truth, found.wrong);
}

EvaluatedFrame evaluate(const std::pair<Experiment, Plan>& planned, const std::string& dataset,
                        std::size_t index, const std::string& method) {
  const auto& [experiment, plan] = planned;
  for (const PlannedDataset& data : plan.datasets)
    for (const MethodSpec& spec : experiment.methods) {
      if (data.spec.name != dataset || spec.name != method) continue;
      EvaluatedFrame result{
          process_again(data, data.frames.at(index), spec, static_cast<std::uint64_t>(experiment.seed)), {}};
      if (result.frame.truth) result.score = score_frame(*result.frame.truth, result.frame.prediction);
      return result;
    }
  throw Error(ErrorKind::internal,
              "no data set " + dataset + " or method " + method + " in the figure's file");
}

cv::Mat surfaces_panel(const EvaluatedFrame& evaluated, const std::string& title) {
  const Prediction& prediction = evaluated.frame.prediction;
  return with_title(draw_surfaces(evaluated.frame.frame, prediction, surface_colors(prediction.labels)),
                    title);
}

cv::Mat color_panel(const EvaluatedFrame& evaluated, const std::string& title) {
  return with_title(draw_color(evaluated.frame.frame), title);
}

}  // namespace facet
