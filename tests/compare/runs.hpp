#pragma once

#include <string>
#include <vector>

#include "core/random.hpp"
#include "record/run_record.hpp"

namespace facet {

/// A run of method "m" on data set "d": frame i has 10 surfaces, of which found[i] are detected.
inline RunRecord run_with(const std::vector<int>& found) {
  RunRecord run;
  for (std::size_t i = 0; i < found.size(); ++i) {
    FrameRow row;
    row.dataset = "d";
    row.method = "m";
    row.frame = "f" + std::to_string(i);
    row.input_hash = "input of " + row.frame;
    row.score.emplace();
    row.score->annotated.surfaces = true;
    row.score->surfaces_50 = {.truth = 10, .detected = found[i]};
    run.frames.push_back(row);
  }
  return run;
}

/// Gives a run 20 repeats of a stage "work" of 10 ms times `factor` and a stage "rest" of 5 ms per frame,
/// both times `machine`, with 2 % of noise, and the calibration block of 4 ms times `machine`.
inline void add_times(RunRecord& run, double factor, double machine, std::uint64_t seed) {
  run.timing.stages = {"work", "rest"};
  std::uint64_t i = 0;
  for (const FrameRow& row : run.frames) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      const auto noisy = [&](double ms) { return ms * machine * (1 + 0.02 * random_uniform(seed, 0, i++)); };
      TimingSample sample{row.dataset, row.frame, row.method};
      sample.repeat = repeat;
      sample.stage_ms = {noisy(10 * factor), noisy(5)};
      sample.total_ms = sample.stage_ms[0] + sample.stage_ms[1];
      run.timing.samples.push_back(sample);
    }
    run.io_times.push_back({row.dataset, row.frame, row.method, "calibration", 4 * machine});
  }
}

}  // namespace facet
