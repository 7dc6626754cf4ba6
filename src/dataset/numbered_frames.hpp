#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace facet {

/// A frame whose name says when it was recorded.
struct NumberedFrame {
  std::string id;
  double timestamp_s = 0;
};

/// Frames of a recording that numbers them at a known rate.
struct NumberedFrames {
  std::vector<NumberedFrame> frames;  ///< in the order of time
  std::vector<std::string> remarks;   ///< what is missing, or was left out
};

/// The time of each frame is the last number of its name divided by `rate_hz`. Names without a number, and
/// those whose number another name has, are left out.
NumberedFrames number_frames(const std::vector<std::string>& ids, double rate_hz);

/// How many frames a recording has lost by the gaps between its times, which ascend; their usual distance is
/// the median.
std::size_t frames_lost(const std::vector<double>& times_s);

}  // namespace facet
