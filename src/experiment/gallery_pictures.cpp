#include "experiment/gallery_pictures.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "experiment/dataset_truth.hpp"
#include "experiment/experiment_reader.hpp"
#include "experiment/run_directory.hpp"
#include "experiment/study_expansion.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"
#include "file/portable_name.hpp"
#include "method/registry.hpp"
#include "overlay/overlay.hpp"
#include "record/run_record.hpp"
#include "report/gallery_section.hpp"
#include "score/truth_prediction.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

/// More than the pipeline's longest temporal window.
constexpr std::size_t remembered_frames = 16;

struct Place {
  const PlannedDataset* planned = nullptr;
  std::size_t index = 0;
  const MethodSpec* method = nullptr;
};

Place place_of(const Experiment& experiment, const Plan& plan, const GalleryEntry& entry) {
  Place place;
  for (const MethodSpec& method : experiment.methods)
    if (method.name == entry.method) place.method = &method;
  for (const PlannedDataset& planned : plan.datasets)
    for (const std::size_t index : planned.frames)
      if (planned.spec.name == entry.dataset && escaped_utf8(planned.data->frame_id(index)) == entry.frame) {
        place.planned = &planned;
        place.index = index;
      }
  if (place.planned == nullptr || place.method == nullptr)
    throw Error(ErrorKind::data, "the frame or the method is not there any more");
  return place;
}

void draw_entry(const Experiment& experiment, const Plan& plan, const fs::path& directory,
                GalleryEntry& entry) {
  const Place place = place_of(experiment, plan, entry);
  const FrameAgain again =
      process_again(*place.planned, place.index, *place.method, static_cast<std::uint64_t>(experiment.seed));
  std::optional<Prediction> truth;
  if (again.truth) truth = truth_as_prediction(*again.truth);
  const fs::path file =
      fs::path("gallery") / entry.method / entry.dataset / (portable_name(entry.frame) + ".png");
  write_png_file(directory / file, draw_comparison(again.frame, again.prediction, truth));
  entry.picture = file.generic_string();
}

Study study_of(const Experiment& experiment) {
  if (!experiment.ablations.empty()) return Study::ablation;
  return experiment.sweep.empty() ? Study::none : Study::sweep;
}

std::string command_of(Study study) {
  switch (study) {
    case Study::ablation:
      return "facet ablate";
    case Study::sweep:
      return "facet sweep";
    default:
      return "facet run";
  }
}

}  // namespace

FrameAgain process_again(const PlannedDataset& planned, std::size_t index, const MethodSpec& spec,
                         std::uint64_t seed) {
  const auto method = make_method(spec, {planned.data->sensor(), seed, 1});
  FrameAgain again;
  StageTimes times;
  const std::size_t past =
      planned.data->is_sequence() ? std::min(index - planned.frames.front(), remembered_frames) : 0;
  for (std::size_t i = index - past; i <= index; ++i) {
    again.frame = planned.data->load(i);
    method->process(again.frame, again.prediction, times);
  }
  std::string source;
  again.truth = read_truth(*planned.data, index, again.frame, source);
  return again;
}

std::vector<std::string> draw_gallery(const Experiment& experiment, const Plan& plan,
                                      const fs::path& directory, std::vector<GalleryEntry>& entries) {
  std::vector<std::string> problems;
  for (GalleryEntry& entry : entries) {
    try {
      draw_entry(experiment, plan, directory, entry);
    } catch (const Error& e) {
      if (e.kind() == ErrorKind::internal) throw;  // a full disk is no property of the frame
      problems.push_back(
          fmt::format("{}/{} ({}): not drawn: {}", entry.dataset, entry.frame, entry.method, e.what()));
    }
  }
  return problems;
}

Report make_gallery(const GalleryRequest& request) {
  const RunRecord run = read_run(request.run);
  const auto count = static_cast<std::size_t>(request.worst);
  std::vector<GalleryEntry> entries =
      request.baseline ? worst_frames(run.frames, read_run(*request.baseline).frames, request.metric, count)
                       : worst_frames(run.frames, request.metric, count);
  if (entries.empty())
    throw Error(ErrorKind::not_measured,
                fmt::format("no frame of {} has a value of {}; --film shows sequences without truth",
                            printable(request.run), request.metric));
  const fs::path config = request.run / "config.resolved.yaml";
  const Experiment source = load_experiment(config, {}).experiment;
  const Study study = study_of(source);
  std::vector<std::string> problems;
  try {
    RunOptions options;
    options.data_root = request.data_root;
    const Experiment experiment = expand_study(source, study);
    problems = draw_gallery(experiment, make_plan(experiment, options), request.run, entries);
  } catch (const Error& e) {  // without the data there are still the run's own pictures
    if (e.kind() == ErrorKind::internal) throw;
    problems = {std::string("not drawn anew: ") + e.what()};
  }
  write_file_atomically(request.run / "gallery/gallery.json", to_json(entries));
  ReportSection section = gallery_section(entries, command_of(study) + ' ' + config.string());
  section.paragraphs.insert(section.paragraphs.end(), problems.begin(), problems.end());
  const Report report{"Facet: worst frames of " + run.manifest.experiment, {std::move(section)}};
  write_file_atomically(request.run / "report/gallery.html", render_html(report, request.run));
  return report;
}

}  // namespace facet
