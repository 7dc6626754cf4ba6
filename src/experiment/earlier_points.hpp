#pragma once

#include <filesystem>

#include "experiment/frame_work.hpp"
#include "experiment/run_directory.hpp"
#include "record/run_record.hpp"

namespace facet {

/// What earlier runs of an experiment have of a new one.
struct EarlierPoints {
  std::vector<FrameRow> rows;  ///< as rows of the new run
  TimingTable timing;
  std::vector<IoTime> io_times;  ///< calibrations beside those times
};

/// Looks through the runs beside `directory` for methods that compute the same on the same data sets, by the
/// same build (parameters, seed, score and output options; the frames' checksums are compared when the frames
/// are read). Copies their predictions and pictures into `directory`. What cannot be read is passed over.
EarlierPoints adopt_earlier_points(const Experiment& expanded, const RunIdentity& identity,
                                   const RunDirectory& directory);

}  // namespace facet
