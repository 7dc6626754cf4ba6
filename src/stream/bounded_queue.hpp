#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace facet {

/// How full a queue was, from its first item until it was closed.
struct QueueStatistics {
  std::size_t capacity = 0;
  std::uint64_t taken_in = 0;  ///< items, the dropped ones among them
  std::uint64_t dropped = 0;
  std::size_t max_depth = 0;
  double mean_depth = 0;  ///< over time
};

/// An item that has left a queue, and its number among those that did.
template <class T>
struct Taken {
  T item;
  std::uint64_t ticket = 0;
};

/// A first-in first-out queue of at most `capacity` items in a circular buffer (paper, section 4.1.2), for
/// any number of threads at either end.
template <class T>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t capacity) : slots_(capacity) {}

  /// Waits for room. False where the queue was stopped: the item is lost.
  bool push(T item) {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [&] { return stopped_ || count_ < slots_.size(); });
    return put(std::move(item));
  }
  /// Never waits: in a full queue the oldest item gives way. False where the queue was stopped.
  bool push_over_oldest(T item) {
    const std::lock_guard lock(mutex_);
    if (!stopped_ && count_ == slots_.size()) {
      take_front();
      ++statistics_.dropped;
    }
    return put(std::move(item));
  }
  /// Waits for an item. Nothing where the queue was stopped, or closed and is empty.
  std::optional<Taken<T>> pop() {
    std::unique_lock lock(mutex_);
    items_.wait(lock, [&] { return stopped_ || closed_ || count_ > 0; });
    if (stopped_ || count_ == 0) return std::nullopt;
    Taken<T> taken{take_front(), next_ticket_++};
    room_.notify_one();
    return taken;
  }
  /// No more items will come; those that wait can still be popped.
  void close() {
    const std::lock_guard lock(mutex_);
    note_depth();
    closed_ = true;
    items_.notify_all();
  }
  /// Whoever waits at the queue, or comes to it later, goes away empty-handed.
  void stop() {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    items_.notify_all();
    room_.notify_all();
  }
  QueueStatistics statistics() const {
    const std::lock_guard lock(mutex_);
    QueueStatistics result = statistics_;
    result.capacity = slots_.size();
    const double seconds = std::chrono::duration<double>(noted_ - first_).count();
    result.mean_depth = seconds > 0 ? depth_seconds_ / seconds : 0;
    return result;
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool put(T item) {
    if (stopped_) return false;
    note_depth();
    slots_[(front_ + count_) % slots_.size()] = std::move(item);
    ++count_;
    ++statistics_.taken_in;
    statistics_.max_depth = std::max(statistics_.max_depth, count_);
    items_.notify_one();
    return true;
  }
  T take_front() {
    note_depth();
    T item = std::move(slots_[front_]);
    front_ = (front_ + 1) % slots_.size();
    --count_;
    return item;
  }
  /// Adds the time since the last change at the depth that held then.
  void note_depth() {
    if (closed_) return;
    const Clock::time_point now = Clock::now();
    if (statistics_.taken_in == 0) first_ = noted_ = now;
    depth_seconds_ += static_cast<double>(count_) * std::chrono::duration<double>(now - noted_).count();
    noted_ = now;
  }

  mutable std::mutex mutex_;
  std::condition_variable items_, room_;
  std::vector<T> slots_;
  std::size_t front_ = 0, count_ = 0;
  std::uint64_t next_ticket_ = 0;
  bool closed_ = false, stopped_ = false;
  QueueStatistics statistics_;
  Clock::time_point first_{}, noted_{};
  double depth_seconds_ = 0;
};

}  // namespace facet
