#include "stream/filter_chain.hpp"

#include <ctime>

namespace facet {
namespace {

double thread_cpu_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

}  // namespace

FilterChain::FilterChain(std::vector<Filter> filters, std::size_t queue_frames)
    : filters_(std::move(filters)), exits_(filters_.size()), running_(filters_.size()) {
  for (std::size_t i = 0; i <= filters_.size(); ++i) queues_.emplace_back(queue_frames);
  for (std::size_t i = 0; i < filters_.size(); ++i) running_[i] = filters_[i].threads;
  try {
    for (std::size_t i = 0; i < filters_.size(); ++i)
      for (int k = 0; k < filters_[i].threads; ++k) threads_.emplace_back([this, i] { run(i); });
  } catch (...) {  // no more threads to be had: those that run must not wait for ever
    stop();
    throw;
  }
}

FilterChain::~FilterChain() {
  stop();
}

std::optional<Passage> FilterChain::take() {
  std::optional<Taken<Passage>> taken = queues_.back().pop();
  if (taken) return std::move(taken->item);
  const std::lock_guard lock(error_mutex_);
  if (error_) std::rethrow_exception(error_);
  return std::nullopt;
}

void FilterChain::fail(std::exception_ptr error) {
  {
    const std::lock_guard lock(error_mutex_);
    if (!error_) error_ = std::move(error);
  }
  stop();
}

std::vector<QueueStatistics> FilterChain::queue_statistics() const {
  std::vector<QueueStatistics> statistics;
  for (const BoundedQueue<Passage>& queue : queues_) statistics.push_back(queue.statistics());
  return statistics;
}

void FilterChain::run(std::size_t filter) {
  try {
    pass_frames(filter);
  } catch (...) {
    fail(std::current_exception());
  }
  if (--running_[filter] == 0) queues_[filter + 1].close();
}

void FilterChain::pass_frames(std::size_t filter) {
  while (std::optional<Taken<Passage>> taken = queues_[filter].pop()) {
    Passage& passage = taken->item;
    const StreamClock::time_point start = StreamClock::now();
    const double cpu_start_ms = thread_cpu_ms();
    if (filter == 0) passage.entered = start;
    filters_[filter].work(passage);
    passage.filters[filter] = {std::chrono::duration<double, std::milli>(StreamClock::now() - start).count(),
                               thread_cpu_ms() - cpu_start_ms};
    // A frame that was faster than the one before waits for it.
    if (!exits_[filter].wait_turn(taken->ticket)) return;
    queues_[filter + 1].push(std::move(passage));
    exits_[filter].pass();
  }
}

void FilterChain::stop() {
  for (BoundedQueue<Passage>& queue : queues_) queue.stop();
  for (Turnstile& exit : exits_) exit.stop();
}

}  // namespace facet
