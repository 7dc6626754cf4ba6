#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <tuple>
#include <vector>

#include "experiment/data_lock.hpp"
#include "experiment/plan.hpp"
#include "method/method.hpp"
#include "method/wall_time.hpp"
#include "record/frame_row.hpp"
#include "record/timing_row.hpp"
#include "score/frame_score.hpp"

namespace facet {

/// What tells results apart beside data set, frame and method.
struct RunIdentity {
  std::string config_hash;
  std::string build;
};

/// Takes one frame through one method and writes what comes of it. Usable from several threads, each with
/// methods of its own.
class FrameWork {
 public:
  FrameWork(const Experiment& experiment, const Plan& plan, RunIdentity identity,
            std::filesystem::path directory)
      : experiment_(experiment),
        plan_(plan),
        identity_(std::move(identity)),
        directory_(std::move(directory)) {}

  /// Rows of an earlier attempt: a frame is done when configuration, input and build agree.
  void keep_finished(const std::vector<FrameRow>& rows);
  /// The row of frame `frame` of the unit's data set, and whether it was finished before. A frame that cannot
  /// be read or processed gives a row that says so; outputs that cannot be written throw.
  /// `tracker` follows the unit's sequence, whose frames come in order.
  std::pair<FrameRow, bool> evaluate(const Unit& unit, std::size_t frame, Method& method,
                                     StabilityTracker& tracker);

  const DataLock& data_lock() const { return data_lock_; }
  DataLock& data_lock() { return data_lock_; }
  /// Times of writing and of programs, in no particular order.
  const std::vector<IoTime>& io_times() const { return io_times_; }

 private:
  using Key = std::tuple<std::string, std::string, std::string>;

  /// The truth of the frame, where scores are wanted and it has one; notes where it is from.
  std::optional<FrameTruth> truth_of(const Dataset& data, std::size_t index, Frame& frame,
                                     FrameRow& row) const;
  PredictedParts predicted_parts(const Unit& unit, const Prediction& prediction) const;
  void note_program_time(const Unit& unit, const FrameRow& row, const StageTimes& times);
  void write_outputs(Frame& frame, const Prediction& prediction, FrameRow& row);

  const Experiment& experiment_;
  const Plan& plan_;
  RunIdentity identity_;
  std::filesystem::path directory_;
  std::map<Key, FrameRow> finished_;
  DataLock data_lock_;
  std::mutex mutex_;
  std::vector<IoTime> io_times_;
};

}  // namespace facet
