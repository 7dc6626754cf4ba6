#include "experiment/timing_pass.hpp"

#include <tbb/task_arena.h>

#include "experiment/calibration.hpp"
#include "experiment/frame_work.hpp"
#include "file/file_bytes.hpp"
#include "method/registry.hpp"
#include "pipeline/stage_id.hpp"

namespace facet {
namespace {

/// Times one method on one data set.
class MethodTimer {
 public:
  MethodTimer(const Experiment& experiment, Backend backend, const PlannedDataset& planned,
              const MethodSpec& spec, Timings& timings)
      : options_(experiment.timing),
        planned_(planned),
        spec_(spec),
        timings_(timings),
        method_(make_method(spec, {planned.data->sensor(),
                                   static_cast<std::uint64_t>(experiment.seed),
                                   experiment.timing.threads,
                                   {},
                                   backend})) {}

  Frame load(std::size_t index) {
    Frame frame;
    const double ms = milliseconds_of([&] { frame = planned_.data->load(index); });
    timings_.io_times.push_back({planned_.data->name(), escaped_utf8(frame.id), "", "decode", ms});
    return frame;
  }
  void forget() { method_->reset_history(); }
  /// Times the calibration block beside what is timed, so that ratios to it follow the load of the machine.
  void calibrate(const std::string& frame_id) {
    for (int i = 0; i < calibrations_at_once; ++i)
      timings_.io_times.push_back(
          {planned_.data->name(), escaped_utf8(frame_id), spec_.name, "calibration", block_.run_ms()});
  }
  /// Run number `run` over a frame, warm-up runs first.
  void run(const Frame& frame, int run) {
    StageTimes times;
    method_->process(frame, prediction_, times);
    TimingSample sample{planned_.data->name(), escaped_utf8(frame.id), spec_.name};
    sample.phase = first_                  ? TimingPhase::first
                   : run < options_.warmup ? TimingPhase::warmup
                                           : TimingPhase::steady;
    sample.repeat = sample.phase == TimingPhase::steady ? run - options_.warmup : run;
    sample.surfaces = static_cast<int>(prediction_.surfaces.size());
    for (const Surface& surface : prediction_.surfaces) sample.posed += surface.pose.has_value();
    sample.total_ms = times.total_ms;
    if (find_method_kind(spec_).has_stages)
      sample.stage_ms.assign(times.stage_ms.begin(), times.stage_ms.end());
    timings_.table.samples.push_back(std::move(sample));
    first_ = false;
  }
  int runs() const { return options_.warmup + options_.repeats; }

 private:
  static constexpr int calibrations_at_once = 3;

  const TimingOptions& options_;
  const PlannedDataset& planned_;
  const MethodSpec& spec_;
  Timings& timings_;
  std::unique_ptr<Method> method_;
  CalibrationBlock block_;
  Prediction prediction_;
  bool first_ = true;
};

void time_stills(MethodTimer& timer, const std::vector<std::size_t>& frames, const auto& proceed) {
  for (const std::size_t index : frames) {
    const Frame frame = timer.load(index);
    // Before the warm-up, which refills the caches, and after the last run.
    timer.calibrate(frame.id);
    for (int run = 0; run < timer.runs(); ++run) {
      timer.forget();
      timer.run(frame, run);
    }
    timer.calibrate(frame.id);
    if (!proceed(static_cast<std::size_t>(timer.runs()))) return;
  }
}

void time_sequence(MethodTimer& timer, const std::vector<std::size_t>& frames, const auto& proceed) {
  for (int run = 0; run < timer.runs(); ++run) {
    timer.calibrate("");
    timer.forget();
    for (const std::size_t index : frames) {
      timer.run(timer.load(index), run);
      if (!proceed(1)) return;
    }
  }
}

std::vector<std::size_t> frames_to_time(const PlannedDataset& planned, const std::string& method,
                                        const FrameKeys& keys) {
  std::vector<std::size_t> frames;
  for (const std::size_t index : planned.frames)
    if (keys.contains({planned.data->name(), escaped_utf8(planned.data->frame_id(index)), method}))
      frames.push_back(index);
  return frames;
}

}  // namespace

Timings run_timing_pass(const Experiment& experiment, const Plan& plan, const FrameKeys& keys,
                        RunObserver& observer, const std::atomic<int>& stop_signal) {
  Timings timings;
  for (const StageName& stage : stage_names) timings.table.stages.emplace_back(stage.key);
  const std::size_t planned_runs =
      keys.size() * static_cast<std::size_t>(experiment.timing.warmup + experiment.timing.repeats);
  std::size_t done = 0;
  // Within its own arena the pass cannot borrow more threads than it reports.
  tbb::task_arena arena(experiment.timing.threads);
  for (const PlannedDataset& planned : plan.datasets) {
    for (const MethodSpec& spec : experiment.methods) {
      const auto frames = frames_to_time(planned, spec.name, keys);
      if (frames.empty() || stop_signal != 0 || !find_method_kind(spec).computes_here) continue;
      const auto proceed = [&](std::size_t runs) {
        observer.on_step("timing " + spec.name + " on " + planned.data->name(), done += runs, planned_runs);
        return stop_signal == 0;
      };
      arena.execute([&] {
        MethodTimer timer(experiment, plan.backend.backend, planned, spec, timings);
        if (planned.data->is_sequence())
          time_sequence(timer, frames, proceed);
        else
          time_stills(timer, frames, proceed);
      });
    }
  }
  return timings;
}

}  // namespace facet
