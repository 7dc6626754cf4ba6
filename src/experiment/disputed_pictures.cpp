#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "core/error.hpp"
#include "experiment/dataset_truth.hpp"
#include "experiment/gallery_pictures.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"
#include "file/portable_name.hpp"
#include "overlay/strip.hpp"
#include "prediction/prediction_io.hpp"
#include "score/truth_prediction.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t steps_per_row = 4;

/// Strips below each other, white where the last is shorter.
cv::Mat draw_rows(const Frame& frame, const std::vector<StripStep>& steps) {
  cv::Mat picture;
  for (std::size_t i = 0; i < steps.size(); i += steps_per_row) {
    const auto begin = steps.begin() + static_cast<std::ptrdiff_t>(i);
    const auto end = steps.begin() + static_cast<std::ptrdiff_t>(std::min(i + steps_per_row, steps.size()));
    cv::Mat row = draw_strip(frame, {begin, end});
    if (!picture.empty())
      cv::copyMakeBorder(row, row, 0, 0, 0, picture.cols - row.cols, cv::BORDER_CONSTANT,
                         cv::Scalar::all(255));
    if (picture.empty())
      picture = row;
    else
      cv::vconcat(picture, row, picture);
  }
  return picture;
}

std::vector<StripStep> steps_of(const PlannedDataset& planned, std::size_t index, Frame& frame,
                                const Experiment& experiment, const fs::path& predictions) {
  std::vector<StripStep> steps;
  std::string source;
  if (const auto truth = read_truth(*planned.data, index, frame, source))
    steps.push_back({"truth", truth_as_prediction(*truth)});
  for (const MethodSpec& method : experiment.methods) {
    const fs::path stem = predictions / method.name / planned.spec.name / portable_name(frame.id);
    if (fs::exists(PredictionFiles(stem).labels)) steps.push_back({method.name, read_prediction(stem)});
  }
  return steps;
}

void draw(const Experiment& experiment, const Plan& plan, const fs::path& directory, GalleryEntry& entry) {
  for (const PlannedDataset& planned : plan.datasets)
    for (const std::size_t index : planned.frames) {
      if (planned.spec.name != entry.dataset || escaped_utf8(planned.data->frame_id(index)) != entry.frame)
        continue;
      Frame frame = planned.data->load(index);
      const auto steps = steps_of(planned, index, frame, experiment, directory / "predictions");
      if (steps.empty()) throw Error(ErrorKind::data, "no predictions are stored");
      const fs::path file =
          fs::path("gallery/disputed") / entry.dataset / (portable_name(entry.frame) + ".png");
      write_png_file(directory / file, draw_rows(frame, steps));
      entry.picture = file.generic_string();
    }
}

}  // namespace

std::vector<std::string> draw_disputed(const Experiment& experiment, const Plan& plan,
                                       const fs::path& directory, std::vector<GalleryEntry>& entries) {
  std::vector<std::string> problems;
  for (GalleryEntry& entry : entries) {
    try {
      draw(experiment, plan, directory, entry);
    } catch (const Error& e) {
      if (e.kind() == ErrorKind::internal) throw;
      problems.push_back(fmt::format("{}/{}: not drawn: {}", entry.dataset, entry.frame, e.what()));
    }
  }
  return problems;
}

}  // namespace facet
