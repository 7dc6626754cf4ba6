#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace facet {

/// Lets threads pass in the order of their tickets 0, 1, 2, ...
class Turnstile {
 public:
  /// Waits until all smaller tickets have passed. False where it was stopped.
  bool wait_turn(std::uint64_t ticket) {
    std::unique_lock lock(mutex_);
    turn_changed_.wait(lock, [&] { return stopped_ || turn_ == ticket; });
    return !stopped_;
  }
  /// To be called by the thread whose turn it is.
  void pass() {
    const std::lock_guard lock(mutex_);
    ++turn_;
    turn_changed_.notify_all();
  }
  void stop() {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    turn_changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable turn_changed_;
  std::uint64_t turn_ = 0;
  bool stopped_ = false;
};

}  // namespace facet
