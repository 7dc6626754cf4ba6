#include "experiment/experiment_run.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "experiment/ablation_strips.hpp"
#include "experiment/build_info.hpp"
#include "experiment/calibration.hpp"
#include "experiment/publish_rows.hpp"
#include "experiment/run_description.hpp"
#include "experiment/study_expansion.hpp"
#include "experiment/timing_pass.hpp"
#include "experiment/wanted_galleries.hpp"
#include "file/file_bytes.hpp"
#include "method/stored_predictions.hpp"
#include "report/timing_summary.hpp"
#include "report/write_report.hpp"

namespace facet {
namespace {

/// What a data set lacks of what its description asks for; of its frames, those that were planned.
std::vector<std::string> gaps_of(const PlannedDataset& planned) {
  std::vector<std::string> gaps;
  for (const std::string& frame : planned.data->absent())
    gaps.push_back(fmt::format("data set {}: {}", planned.spec.name, frame));
  for (const std::size_t frame : planned.frames) {
    const std::string shortfall = planned.data->shortfall(frame);
    if (shortfall.empty()) continue;
    gaps.push_back(
        fmt::format("data set {}: {}: {}", planned.spec.name, planned.data->frame_id(frame), shortfall));
  }
  return gaps;
}

/// Stored predictions that belong to no frame of the run's data sets.
std::vector<std::string> extra_predictions(const MethodSpec& method, const Plan& plan) {
  if (method.kind != "predictions" || method.folder.empty()) return {};
  std::vector<std::string> ids, notes;
  for (const PlannedDataset& planned : plan.datasets)
    for (std::size_t i = 0; i < planned.data->size(); ++i) ids.push_back(planned.data->frame_id(i));
  for (const std::string& id : predictions_without_frame(method, ids))
    notes.push_back(fmt::format("method {}: prediction without a frame: {}", method.name, escaped_utf8(id)));
  return notes;
}

}  // namespace

ExperimentRun::ExperimentRun(const Experiment& experiment, const RunOptions& options, RunObserver& observer,
                             const std::atomic<int>& stop_signal)
    : source_(experiment),
      experiment_(expand_study(experiment, options.study)),
      options_(options),
      observer_(observer),
      stop_signal_(stop_signal),
      plan_(check_experiment(experiment_, options)),
      identity_(make_identity(experiment, options, plan_)),
      directory_(open_directory()) {}

RunOutcome ExperimentRun::execute() {
  describe_run();
  adopt_points();
  AccuracyPass pass(experiment_, plan_, identity_, directory_, options_, observer_, stop_signal_);
  rows_ = pass.run();
  count_rows(rows_, manifest_);
  note_gaps();
  publish_lock(directory_, plan_, pass.work().data_lock());
  const bool stopped_early = options_.fail_fast && failed() > 0;
  if (stop_signal_ == 0) publish_results(pass, stopped_early);
  return finish(stopped_early);
}

RunDirectory ExperimentRun::open_directory() {
  // The parts of a run have folders of their own.
  const std::string build =
      build_info().name() + (options_.shard.is_whole()
                                 ? ""
                                 : fmt::format("-shard{}of{}", options_.shard.index, options_.shard.count));
  if (options_.resume) {
    if (auto found = RunDirectory::find(options_.out, experiment_.name, identity_.config_hash, build)) {
      observer_.on_note("resuming " + printable(found->path()));
      remove_temporary_files(found->path());  // what a kill in the middle of a write has left
      return *found;
    }
    observer_.on_note("nothing to resume, starting anew");
  }
  return RunDirectory::create(options_.out, experiment_.name, identity_.config_hash, build);
}

void ExperimentRun::describe_run() {
  manifest_ = make_manifest(experiment_, options_, plan_, identity_);
  observer_.on_note(fmt::format("back end {}: {}", manifest_.backend, plan_.backend.reason));
  for (const PlannedDataset& planned : plan_.datasets)
    if (!planned.spec.root.empty())
      observer_.on_note(
          fmt::format("data set {} is read from {}", planned.spec.name, printable(planned.spec.root)));
  publish_description(directory_, source_, manifest_);
}

void ExperimentRun::note_gaps() {
  for (const PlannedDataset& planned : plan_.datasets) {
    for (std::string& gap : gaps_of(planned)) manifest_.notes.push_back(std::move(gap));
  }
  for (const MethodSpec& method : experiment_.methods)
    for (std::string& extra : extra_predictions(method, plan_)) manifest_.notes.push_back(std::move(extra));
}

void ExperimentRun::publish_galleries() {
  for (WantedGallery& gallery : wanted_galleries(experiment_.outputs, rows_)) {
    if (gallery.entries.empty()) {
      manifest_.notes.emplace_back(gallery.why_empty);
      continue;
    }
    for (std::string& problem : gallery.draw(experiment_, plan_, directory_.path(), gallery.entries))
      manifest_.notes.push_back(std::move(problem));
    directory_.publish(gallery.file, to_json(gallery.entries));
  }
}

void ExperimentRun::publish_strips() {
  const bool kept = experiment_.outputs.overlays && experiment_.outputs.predictions;
  if (options_.study == Study::ablation && kept)
    write_ablation_strips(plan_ablations(source_.ablations, source_.methods), plan_, directory_.path());
}

/// Programs are timed whether or not there is a timing pass.
void ExperimentRun::publish_program_times(const AccuracyPass& pass) {
  std::vector<IoTime> times = pass.work().io_times();
  std::erase_if(times, [](const IoTime& t) { return t.what != "program"; });
  if (!times.empty()) directory_.publish("timing/io.csv", to_csv(times));
}

void ExperimentRun::time_methods(const AccuracyPass& pass) {
  const bool timed_before = std::filesystem::exists(directory_.path() / "timing/samples.csv");
  if (experiment_.timing.repeats == 0) return publish_program_times(pass);
  if (timed_before && pass.new_rows() == 0) return;
  FrameKeys keys;
  for (const FrameRow& row : rows_)
    if (row.status == FrameStatus::ok) keys.insert({row.dataset, row.frame, row.method});
  for (const TimingSample& sample : adopted_.timing.samples)
    keys.erase({sample.dataset, sample.frame, sample.method});
  const Calibration calibration = measure_calibration();
  Timings timings = run_timing_pass(experiment_, plan_, keys, observer_, stop_signal_);
  if (stop_signal_ != 0) return;
  timings.table.samples.insert(timings.table.samples.end(), adopted_.timing.samples.begin(),
                               adopted_.timing.samples.end());
  std::vector<IoTime> io_times = std::move(timings.io_times);
  io_times.insert(io_times.end(), adopted_.io_times.begin(), adopted_.io_times.end());
  io_times.insert(io_times.end(), pass.work().io_times().begin(), pass.work().io_times().end());
  directory_.publish("timing/calibration.json", to_json(calibration));
  directory_.publish("timing/io.csv", to_csv(io_times));
  directory_.publish("timing/stages.csv", stages_csv(summarize_timing(timings.table)));
  directory_.publish("timing/samples.csv", to_csv(timings.table));
}

void ExperimentRun::publish_results(const AccuracyPass& pass, bool stopped_early) {
  publish_rows(directory_, experiment_, manifest_, rows_);
  publish_galleries();
  publish_strips();
  if (!stopped_early) time_methods(pass);
  // What is paired over all frames is for the whole run: merge does it for shards.
  if (stop_signal_ != 0 || !options_.shard.is_whole()) return;
  publish_study(directory_, source_, options_.study);
}

/// Points that an earlier sweep has computed are taken over as if this run had been resumed.
void ExperimentRun::adopt_points() {
  if (options_.study != Study::sweep || options_.resume) return;
  adopted_ = adopt_earlier_points(experiment_, identity_, directory_);
  if (adopted_.rows.empty()) return;
  manifest_.notes.push_back(fmt::format(
      "{} of {} frames times points are those of earlier runs, and so are the times of {} samples",
      adopted_.rows.size(), plan_.frame_count(), adopted_.timing.samples.size()));
  observer_.on_note(manifest_.notes.back());
}

int ExperimentRun::exit_code(bool stopped_early) const {
  if (stop_signal_ != 0) return 128 + stop_signal_;
  if (stopped_early) return 4;
  if (failed() > options_.max_failures) return 5;
  return manifest_.frames_ok == 0 ? 6 : 0;
}

RunOutcome ExperimentRun::finish(bool stopped_early) {
  RunOutcome outcome;
  outcome.exit_code = exit_code(stopped_early);
  outcome.directory = directory_.path();
  manifest_.exit_code = outcome.exit_code;
  manifest_.finished_utc = utc_now();
  manifest_.status = stop_signal_ != 0        ? RunStatus::partial
                     : outcome.exit_code != 0 ? RunStatus::failed
                                              : RunStatus::complete;
  directory_.publish("manifest.json", to_json(manifest_));
  if (stop_signal_ == 0) outcome.report = write_report(directory_.path(), {"md", "html", "tex"});
  return outcome;
}

}  // namespace facet
