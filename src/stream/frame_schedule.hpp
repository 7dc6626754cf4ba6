#pragma once

#include <span>
#include <vector>

#include "stream/stream_options.hpp"

namespace facet {

/// How many of the frames in memory, taken in turn, are offered at the most; 0 = as many as time allows.
std::size_t frame_limit(const StreamOptions& options, std::size_t frames_in_memory);

/// When each frame of a stream is due. Frames are a recording that starts over at its end.
class FrameSchedule {
 public:
  /// `timestamps_s` of the recording; only for the recorded pace, which needs two at least, ascending: else
  /// Error{data}.
  FrameSchedule(const StreamOptions& options, std::span<const double> timestamps_s);

  /// Seconds after the first frame; 0 for all where frames are offered as fast as they are taken.
  double due_s(std::size_t number) const;
  /// As frame_limit() says.
  std::size_t frame_limit() const { return frame_limit_; }
  bool is_paced() const { return pace_ != StreamPace::fastest; }

 private:
  StreamPace pace_;
  double rate_hz_;
  std::size_t frame_limit_;
  std::vector<double> offsets_s_;
  double period_s_ = 0;  ///< of the whole recording
};

}  // namespace facet
