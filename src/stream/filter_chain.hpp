#pragma once

#include <atomic>
#include <deque>
#include <exception>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "stream/bounded_queue.hpp"
#include "stream/passage.hpp"
#include "stream/turnstile.hpp"

namespace facet {

/// What one filter of a chain does with a frame, and how many threads do it, each with a frame of its own.
struct Filter {
  std::string name;
  int threads = 1;
  std::function<void(Passage&)> work;
};

/// Filters joined by bounded queues, each with its threads (paper, section 4.1.2). Frames leave in the order
/// in which they came, whatever the threads do. The first exception of a filter stops all of them, and take()
/// throws it.
class FilterChain {
 public:
  /// Starts the threads; a queue before each filter and one after the last hold `queue_frames` each.
  FilterChain(std::vector<Filter> filters, std::size_t queue_frames);
  /// Stops the threads at the frames they are at.
  ~FilterChain();
  FilterChain(const FilterChain&) = delete;
  FilterChain& operator=(const FilterChain&) = delete;

  /// Waits for room before the first filter. False where the chain was stopped.
  bool offer(Passage passage) { return queues_.front().push(std::move(passage)); }
  /// Never waits: the frame that has waited longest before the first filter gives way.
  bool offer_over_oldest(Passage passage) { return queues_.front().push_over_oldest(std::move(passage)); }
  /// No more frames will be offered.
  void close() { queues_.front().close(); }
  /// The next finished frame, nothing after the last one. Throws what a filter has thrown.
  std::optional<Passage> take();
  /// Stops everything; take() throws `error`, unless there was one before.
  void fail(std::exception_ptr error);
  /// One for the queue before each filter, then that before the sink.
  std::vector<QueueStatistics> queue_statistics() const;

 private:
  void run(std::size_t filter);
  void pass_frames(std::size_t filter);
  void stop();

  std::vector<Filter> filters_;
  std::deque<BoundedQueue<Passage>> queues_;
  std::deque<Turnstile> exits_;
  std::deque<std::atomic<int>> running_;  ///< threads of each filter
  std::mutex error_mutex_;
  std::exception_ptr error_;
  std::vector<std::jthread> threads_;
};

}  // namespace facet
