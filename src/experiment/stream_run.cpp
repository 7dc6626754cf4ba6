#include "experiment/stream_run.hpp"

#include <fmt/format.h>
#include <opencv2/core/utility.hpp>
#include <tbb/global_control.h>

#include "core/error.hpp"
#include "experiment/build_info.hpp"
#include "experiment/run_description.hpp"
#include "file/file_bytes.hpp"
#include "method/pipeline_method.hpp"
#include "report/write_report.hpp"
#include "stream/stream.hpp"
#include "stream/stream_report.hpp"

namespace facet {
namespace {

/// The frames of a data set, in memory.
struct Recording {
  std::vector<Frame> frames;
  std::vector<FrameInput> inputs;
  std::vector<double> timestamps_s;
};

/// Throws where an experiment cannot be streamed.
Plan plan_stream(const Experiment& experiment, const RunOptions& options) {
  for (const MethodSpec& method : experiment.methods)
    if (method.kind != "pipeline")
      throw Error(ErrorKind::config,
                  fmt::format("methods.{}: kind {} cannot be streamed, only a pipeline has stages",
                              method.name, method.kind));
  Plan plan = check_experiment(experiment, options);
  const int warmup = experiment.stream.warmup;
  for (const PlannedDataset& planned : plan.datasets) {
    const std::size_t limit = frame_limit(experiment.stream, planned.frames.size());
    if (limit > 0 && limit <= static_cast<std::size_t>(warmup))
      throw Error(
          ErrorKind::not_measured,
          fmt::format("data set '{}': {} frames are offered and the first {} are warm-up; offer more, "
                      "with --frames N: those in memory are taken in turn",
                      planned.spec.name, limit, warmup));
  }
  return plan;
}

/// One streaming run, from its plan to its report.
class StreamRun {
 public:
  StreamRun(const RunOptions& options, RunObserver& observer, const std::atomic<int>& stop_signal)
      : experiment_(load_experiment(options.config_file, options.overrides).experiment),
        observer_(observer),
        stop_signal_(stop_signal),
        plan_(plan_stream(experiment_, options)),
        identity_(make_identity(experiment_, options, plan_)),
        directory_(
            RunDirectory::create(options.out, experiment_.name, identity_.config_hash, build_info().name())),
        manifest_(make_manifest(experiment_, options, plan_, identity_)) {
    manifest_.study = "stream";
    observer_.on_note(fmt::format("back end {}: {}", manifest_.backend, plan_.backend.reason));
    publish_description(directory_, experiment_, manifest_);
  }

  RunOutcome execute() {
    try {
      for (const PlannedDataset& planned : plan_.datasets) stream_dataset(planned);
      publish_lock(directory_, plan_, data_lock_);
    } catch (const Error& e) {
      manifest_.notes.push_back(escaped_utf8(e.what()));
      finish(RunStatus::failed, e.kind() == ErrorKind::data ? 4 : 70);
      throw;
    }
    const int exit_code = stop_signal_ != 0 ? 128 + stop_signal_ : nothing_counted() ? 6 : 0;
    finish(stop_signal_ != 0 ? RunStatus::partial
           : exit_code != 0  ? RunStatus::failed
                             : RunStatus::complete,
           exit_code);
    return {exit_code, directory_.path(), make_stream_report(experiment_.name, records_)};
  }

 private:
  void stream_dataset(const PlannedDataset& planned) {
    const Recording recording = read(planned);
    for (const MethodSpec& method : experiment_.methods) {
      if (stop_signal_ != 0) return;
      stream(planned, recording, method);
      publish_results();
    }
  }

  Recording read(const PlannedDataset& planned) {
    Recording recording;
    for (const std::size_t index : planned.frames) {
      if (stop_signal_ != 0) break;
      Frame frame = planned.data->load(index);
      data_lock_.input_hash(frame);
      frame.color.release();  // only depth streams: memory is for more frames
      frame.object_masks.reset();
      if (experiment_.stream.pace == StreamPace::recorded && !frame.timestamp_s)
        throw Error(ErrorKind::data,
                    fmt::format("data set '{}', frame {}: its time is not known; offer frames at a rate "
                                "of your own, --rate 30",
                                planned.spec.name, printable(frame.id)));
      recording.timestamps_s.push_back(frame.timestamp_s.value_or(0));
      recording.frames.push_back(std::move(frame));
      observer_.on_step("frames read of " + planned.spec.name, recording.frames.size(),
                        planned.frames.size());
    }
    for (const Frame& frame : recording.frames)
      recording.inputs.push_back({frame.depth_m.view(), frame.camera, {}, {}, frame.counted.view()});
    return recording;
  }

  void stream(const PlannedDataset& planned, const Recording& recording, const MethodSpec& method) {
    const StreamOptions& options = experiment_.stream;
    const FrameSchedule schedule(options, recording.timestamps_s);
    const int threads = experiment_.timing.threads;
    StageFilters filters(options, [&](int count) {
      return make_pipelines(plan_.backend.backend, count, with_sensor(method.params, planned.data->sensor()),
                            static_cast<std::uint64_t>(experiment_.seed), threads);
    });
    filters.warm_up(recording.inputs.front());
    std::size_t done = 0;
    const auto tell = [&](Passage&) {
      observer_.on_step(fmt::format("streaming {} through {}", planned.spec.name, method.name), ++done,
                        schedule.frame_limit());
    };
    StreamRecord record = run_stream(recording.inputs, schedule, options, filters, tell, stop_signal_);
    record.dataset = planned.spec.name;
    record.method = method.name;
    record.threads_in_frame = threads;
    records_.push_back(std::move(record));
  }

  void publish_results() {
    directory_.publish("stream.json", stream_json(records_));
    directory_.publish("timing/stream.csv", stream_csv(records_));
    directory_.publish("report/report.json", render_json(make_stream_report(experiment_.name, records_)));
    write_report(directory_.path(), {"md", "html"});
  }

  bool nothing_counted() const {
    for (const StreamRecord& record : records_)
      if (record.first_counted() == record.samples.size()) return true;
    return records_.empty();
  }

  void finish(RunStatus status, int exit_code) {
    manifest_.frames_planned = 0;
    for (const StreamRecord& record : records_) {
      manifest_.frames_planned += static_cast<int>(record.due);
      manifest_.frames_ok += static_cast<int>(record.samples.size());
    }
    manifest_.status = status;
    manifest_.exit_code = exit_code;
    manifest_.finished_utc = utc_now();
    directory_.publish("manifest.json", to_json(manifest_));
  }

  const Experiment experiment_;
  RunObserver& observer_;
  const std::atomic<int>& stop_signal_;
  Plan plan_;
  RunIdentity identity_;
  RunDirectory directory_;
  Manifest manifest_;
  DataLock data_lock_;
  std::vector<StreamRecord> records_;
};

}  // namespace

RunOutcome run_stream_experiment(const RunOptions& options, RunObserver& observer,
                                 const std::atomic<int>& stop_signal) {
  cv::setNumThreads(0);  // parallelism is over frames: OpenCV adds no threads of its own
  return StreamRun(options, observer, stop_signal).execute();
}

}  // namespace facet
