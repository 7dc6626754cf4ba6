#include "stream/frame_producer.hpp"

#include <algorithm>

namespace facet {

void FrameProducer::run(const std::stop_token& stop, StreamClock::time_point start) {
  start_ = start;
  try {
    while (!is_enough(stop) && wait_until_due(stop) && offer()) {
    }
    count_due();
    chain_.close();
  } catch (...) {
    chain_.fail(std::current_exception());
  }
}

void FrameProducer::count_due() {
  due_ = offered_;
  const std::size_t limit = schedule_.frame_limit();
  StreamClock::time_point end = StreamClock::now();
  if (options_.seconds > 0)
    end = std::min(end, start_ + std::chrono::duration_cast<StreamClock::duration>(
                                     std::chrono::duration<double>(options_.seconds)));
  while (schedule_.is_paced() && (limit == 0 || due_ < limit) && due_time(due_) < end) ++due_;
}

bool FrameProducer::is_enough(const std::stop_token& stop) const {
  const std::size_t limit = schedule_.frame_limit();
  const std::chrono::duration<double> elapsed = StreamClock::now() - start_;
  return stop.stop_requested() || stop_signal_ != 0 || (limit > 0 && offered_ >= limit) ||
         (options_.seconds > 0 && elapsed.count() >= options_.seconds);
}

StreamClock::time_point FrameProducer::due_time(std::size_t number) const {
  return start_ + std::chrono::duration_cast<StreamClock::duration>(
                      std::chrono::duration<double>(schedule_.due_s(number)));
}

bool FrameProducer::wait_until_due(const std::stop_token& stop) const {
  constexpr std::chrono::milliseconds reaction_time{20};
  const StreamClock::time_point end = due_time(offered_);
  while (StreamClock::now() < end) {
    if (is_enough(stop)) return false;
    std::this_thread::sleep_until(std::min(end, StreamClock::now() + reaction_time));
  }
  return true;
}

bool FrameProducer::offer() {
  const bool paced = schedule_.is_paced();
  Passage passage;
  passage.number = offered_;
  passage.frame = &frames_[offered_ % frames_.size()];
  passage.due = paced ? due_time(offered_) : StreamClock::now();
  const bool accepted = options_.policy == QueuePolicy::drop ? chain_.offer_over_oldest(std::move(passage))
                                                             : chain_.offer(std::move(passage));
  if (!accepted) return false;
  ++offered_;
  late_ += paced && StreamClock::now() > due_time(offered_);
  return true;
}

}  // namespace facet
