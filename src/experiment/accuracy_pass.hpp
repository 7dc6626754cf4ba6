#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <mutex>
#include <vector>

#include "experiment/frame_work.hpp"
#include "experiment/run_directory.hpp"
#include "experiment/run_observer.hpp"
#include "method/registry.hpp"

namespace facet {

/// The pass that makes the predictions: units in parallel, results independent of how many at a time. Every
/// finished frame is a line of frames.jsonl at once, which is what a resumed run starts from.
class AccuracyPass {
 public:
  AccuracyPass(const Experiment& experiment, const Plan& plan, const RunIdentity& identity,
               const RunDirectory& directory, const RunOptions& options, RunObserver& observer,
               const std::atomic<int>& stop_signal);

  /// The rows of the frames done, in the order of row_before(); all of them unless a signal or --fail-fast
  /// ended it.
  std::vector<FrameRow> run();
  std::size_t new_rows() const { return new_rows_; }
  FrameWork& work() { return work_; }
  const FrameWork& work() const { return work_; }

 private:
  void restore_finished();
  void prepare_methods() const;
  MethodContext context_of(const Unit& unit) const;
  void run_unit(const Unit& unit, Method& method);
  void add_row(const FrameRow& row, bool finished_before);
  bool should_stop() const { return stop_signal_ != 0 || failed_fast_; }

  const Experiment& experiment_;
  const Plan& plan_;
  const RunDirectory& directory_;
  const RunOptions& options_;
  RunObserver& observer_;
  const std::atomic<int>& stop_signal_;
  FrameWork work_;
  std::unique_ptr<LineLog> rows_log_;
  LineLog event_log_;
  std::atomic<bool> failed_fast_ = false;
  std::mutex mutex_;
  std::vector<FrameRow> rows_;
  std::size_t new_rows_ = 0;
};

}  // namespace facet
