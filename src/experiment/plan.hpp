#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "experiment/experiment.hpp"
#include "experiment/run_options.hpp"
#include "method/backend.hpp"

namespace facet {

/// An opened data set and the frames of it that the run is about.
struct PlannedDataset {
  DatasetSpec spec;  ///< with its root found
  std::unique_ptr<Dataset> data;
  std::vector<std::size_t> frames;
};

/// The least part of a run that can be done by itself: one method over one frame, or over a whole sequence,
/// whose frames must pass in order.
struct Unit {
  std::size_t method = 0;   ///< index in Experiment::methods
  std::size_t dataset = 0;  ///< index in Plan::datasets
  std::vector<std::size_t> frames;
};

struct Plan {
  std::vector<PlannedDataset> datasets;
  std::vector<Unit> units;
  BackendChoice backend;

  std::size_t frame_count() const;  ///< frames times methods
};

/// Opens the data sets and lists the work. Throws Error{data} for a missing or empty data set,
/// Error{not_measured} where filter and limit leave nothing, Error{usage} for a filter that is no regular
/// expression.
Plan make_plan(const Experiment& experiment, const RunOptions& options);

}  // namespace facet
