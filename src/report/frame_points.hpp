#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "record/run_record.hpp"

namespace facet {

/// One frame of a method as a point of a chart.
struct FramePoint {
  const FrameRow* row = nullptr;
  double surfaces = 0;  ///< there: that count in the truth, or found where there is no truth
  double objects = 0;   ///< there
  bool has_truth = false;
  std::optional<double> segmentation_ms;  ///< mean of its steady runs, without poses and grasps

  /// Value of a score in this frame; nothing where it has none.
  std::optional<double> score(const std::string& metric) const;
};

/// The frames of a method on a data set that were processed, or have truth. They point into `run`.
std::vector<FramePoint> frame_points(const RunRecord& run, const std::string& dataset,
                                     const std::string& method);

/// Mean of the steady runs of a frame: total time without poses and grasps, what the paper times.
using FrameTimesMs = std::map<std::tuple<std::string, std::string, std::string>, double>;
FrameTimesMs segmentation_times(const TimingTable& table);

}  // namespace facet
