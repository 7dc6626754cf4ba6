#include "stream/frame_schedule.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"

namespace facet {

std::size_t frame_limit(const StreamOptions& options, std::size_t frames_in_memory) {
  if (options.frames == 0 && options.seconds == 0) return frames_in_memory;
  return static_cast<std::size_t>(options.frames);
}

FrameSchedule::FrameSchedule(const StreamOptions& options, std::span<const double> timestamps_s)
    : pace_(options.pace),
      rate_hz_(options.rate_hz),
      frame_limit_(facet::frame_limit(options, timestamps_s.size())) {
  if (pace_ != StreamPace::recorded) return;
  const auto reject = [](const std::string& rule) {
    throw Error(ErrorKind::data, "recorded pace: " + rule + "; offer the frames at a rate of your own");
  };
  if (timestamps_s.size() < 2) reject("one frame has no rate");
  for (std::size_t i = 0; i < timestamps_s.size(); ++i) {
    if (i > 0 && timestamps_s[i] <= timestamps_s[i - 1])
      reject(fmt::format("frame {} has time {:.6f} s, the frame before has {:.6f} s", i, timestamps_s[i],
                         timestamps_s[i - 1]));
    offsets_s_.push_back(timestamps_s[i] - timestamps_s[0]);
  }
  // Between the last frame and the first of the next round lies the mean distance of two frames.
  period_s_ =
      offsets_s_.back() * static_cast<double>(offsets_s_.size()) / static_cast<double>(offsets_s_.size() - 1);
}

double FrameSchedule::due_s(std::size_t number) const {
  switch (pace_) {
    case StreamPace::fixed:
      return static_cast<double>(number) / rate_hz_;
    case StreamPace::recorded:
      return static_cast<double>(number / offsets_s_.size()) * period_s_ +
             offsets_s_[number % offsets_s_.size()];
    default:
      return 0;
  }
}

}  // namespace facet
