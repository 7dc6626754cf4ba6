#pragma once

#include <atomic>
#include <span>
#include <stop_token>

#include "stream/filter_chain.hpp"
#include "stream/frame_schedule.hpp"

namespace facet {

/// Offers the frames of a recording to a chain, again and again, at the times of a schedule.
class FrameProducer {
 public:
  FrameProducer(std::span<const FrameInput> frames, const FrameSchedule& schedule,
                const StreamOptions& options, FilterChain& chain, const std::atomic<int>& stop_signal)
      : frames_(frames), schedule_(schedule), options_(options), chain_(chain), stop_signal_(stop_signal) {}

  /// Offers frames until it is enough, or one of the two asks to stop; then closes the chain. An exception
  /// fails the chain.
  void run(const std::stop_token& stop, StreamClock::time_point start);
  // After run().
  std::size_t offered() const { return offered_; }
  /// Frames that were due by then, whether or not there was room to offer them.
  std::size_t due() const { return due_; }
  std::size_t late() const { return late_; }

 private:
  bool is_enough(const std::stop_token& stop) const;
  StreamClock::time_point due_time(std::size_t number) const;
  bool wait_until_due(const std::stop_token& stop) const;
  bool offer();
  void count_due();

  std::span<const FrameInput> frames_;
  const FrameSchedule& schedule_;
  const StreamOptions& options_;
  FilterChain& chain_;
  const std::atomic<int>& stop_signal_;
  StreamClock::time_point start_{};
  std::size_t offered_ = 0, due_ = 0, late_ = 0;
};

}  // namespace facet
