#pragma once

#include <map>
#include <string>
#include <vector>

#include "compare/comparison.hpp"

namespace facet {

/// Times of one method on one data set in one run: per frame the lower quartile of its steady repeats, which
/// what else the machine does can only lengthen.
struct QuietTimes {
  std::vector<std::string> stages;                       ///< as in the run, then "total"
  std::map<std::string, std::vector<double>> frames_ms;  ///< per frame one value per stage
  std::map<std::string, double> calibration_ms;          ///< per frame, of the block timed beside it
  /// Per stage how far repeats of a frame scatter: their interquartile range over the lower quartile, median
  /// over frames. Large where the machine was busy with something else.
  std::vector<double> scatter;
};

QuietTimes quiet_times(const RunRecord& run, const MethodOnDataset& what);

}  // namespace facet
