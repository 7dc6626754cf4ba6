// Writes the timing rows that gate_replay_test.cpp replays: record_runs FOLDER, on a machine that does
// nothing else.
#include <cstdio>
#include <exception>
#include <fmt/format.h>

#include "compare/recorded_runs.hpp"
#include "compare/slowed_method.hpp"
#include "dataset/registry.hpp"
#include "experiment/calibration.hpp"
#include "file/file_bytes.hpp"
#include "method/registry.hpp"
#include "record/timing_row.hpp"

namespace {

using namespace facet;

constexpr int warmup = 2, repeats = 10, calibrations = 3;

class Recorder {
 public:
  explicit Recorder(const Dataset& dataset) : dataset_(dataset) {
    for (std::size_t i = 0; i < dataset.size(); ++i) frames_.push_back(dataset.load(i));
    for (const StageId stage : recorded_stages)
      table.stages.emplace_back(stage_names[static_cast<std::size_t>(index_of(stage))].key);
  }
  /// One run over all frames, as the timing pass of `facet run` makes it.
  void record(bool slowed, int number) {
    auto method = make_method({}, {dataset_.sensor(), 1, 1});
    if (slowed) method = std::make_unique<SlowedMethod>(std::move(method), slowed_stage, slowed_share);
    const std::string name = recorded_name(slowed, number);
    for (const Frame& frame : frames_) {
      calibrate(name, frame.id);
      for (int run = -warmup; run < repeats; ++run) {
        method->reset_history();
        time_frame(*method, frame, name, run);
      }
      calibrate(name, frame.id);
    }
    fmt::print("{} recorded\n", name);
    std::fflush(stdout);
  }
  TimingTable table;
  std::vector<IoTime> io_times;

 private:
  void calibrate(const std::string& name, const std::string& frame) {
    for (int i = 0; i < calibrations; ++i)
      io_times.push_back({name, frame, "default", "calibration", block_.run_ms()});
  }
  void time_frame(Method& method, const Frame& frame, const std::string& name, int run) {
    StageTimes times;
    method.process(frame, prediction_, times);
    if (run < 0) return;
    TimingSample sample{.dataset = name, .frame = frame.id, .method = "default", .repeat = run};
    sample.total_ms = times.total_ms;
    for (const StageId stage : recorded_stages)
      sample.stage_ms.push_back(times.stage_ms[static_cast<std::size_t>(index_of(stage))]);
    table.samples.push_back(std::move(sample));
  }

  const Dataset& dataset_;
  std::vector<Frame> frames_;
  CalibrationBlock block_;
  Prediction prediction_;
};

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) return fmt::print(stderr, "usage: record_runs FOLDER\n"), 2;
  DatasetSpec spec;
  spec.name = "gate";
  spec.reader = "benchmark";
  spec.root = FACET_CONFIGS "/synth/gate.yaml";
  const auto dataset = open_dataset(spec);
  Recorder recorder(*dataset);
  for (int run = 0; run < recorded_runs; ++run) {
    recorder.record(run % 2 == 1, run);
    recorder.record(run % 2 == 0, run);
  }
  write_file_atomically(std::filesystem::path(argv[1]) / "samples.csv", to_csv(recorder.table));
  write_file_atomically(std::filesystem::path(argv[1]) / "io.csv", to_csv(recorder.io_times));
  return 0;
} catch (const std::exception& e) {
  fmt::print(stderr, "record_runs: {}\n", e.what());
  return 1;
}
