#include "pipeline/temporal_gate.hpp"

#include <algorithm>

namespace facet {

void TemporalGate::admit(const FrameInput& frame, const TemporalParams& params, const DepthNoise& noise) {
  use_.start = judge(frame, params);
  count_ = use_.start == WindowStart::continued ? std::min(count_ + 1, params.frames) : 1;
  size_ = frame.depth_m.size();
  std::shift_right(times_s_.begin(), times_s_.end(), 1);
  times_s_.front() = frame.timestamp_s;
  use_.frames = count_;
  use_.mean_age_s = mean_age_s();
  if (params.frames == 1 || params.max_motion_sigmas <= 0) return;
  // Motion is measured from a frame of the window or, for some frames, from the last one that left it.
  if (use_.start != WindowStart::continued || ++since_start_ >= params.frames) {
    motion_.start_from(frame, noise);
    since_start_ = 0;
  }
}

WindowStart TemporalGate::judge(const FrameInput& frame, const TemporalParams& params) {
  if (count_ == 0) return WindowStart::first;
  if (size_ != frame.depth_m.size()) return WindowStart::size;
  if (frame.timestamp_s && times_s_.front()) {
    const double apart_s = *frame.timestamp_s - *times_s_.front();
    if (apart_s < 0 || (params.max_gap_s > 0 && apart_s > double{params.max_gap_s})) return WindowStart::gap;
  }
  const bool watched = params.frames > 1 && params.max_motion_sigmas > 0;
  if (watched && motion_.change_sigmas(frame) > double{params.max_motion_sigmas}) return WindowStart::motion;
  return WindowStart::continued;
}

std::optional<double> TemporalGate::mean_age_s() const {
  double sum_s = 0;
  for (int i = 0; i < count_; ++i) {
    const auto& time_s = times_s_[static_cast<std::size_t>(i)];
    if (!time_s || !times_s_.front()) return std::nullopt;
    sum_s += *times_s_.front() - *time_s;
  }
  return sum_s / count_;
}

}  // namespace facet
