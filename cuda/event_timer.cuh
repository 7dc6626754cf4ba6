#pragma once

#include <chrono>
#include <vector>

#include "cuda/work_queue.cuh"

namespace facet {

/// Times pieces of work that are nested in one piece: these by events among the device's work, so that the
/// host need not wait for each; the outer one, which ends when all its work is done, by the clock on the
/// wall. Where the outer one fails, what it left in the queue is not done.
class EventTimer {
 public:
  explicit EventTimer(WorkQueue& queue) : queue_(queue) {}

  /// Adds the time of `work` [ms] to `elapsed_ms`, which must last until the outer piece ends: only then are
  /// the inner ones known.
  template <class Work>
  void time(double& elapsed_ms, const Work& work) {
    if (is_inside_)
      time_by_events(elapsed_ms, work);
    else
      time_by_clock(elapsed_ms, work);
  }

 private:
  struct Piece {
    std::size_t start, stop;  ///< events
    double* elapsed_ms;
  };
  /// Holds while the outer piece runs, however it ends.
  struct Inside {
    explicit Inside(EventTimer& timer) : timer_(timer) { timer_.is_inside_ = true; }
    ~Inside() {
      timer_.is_inside_ = false;
      timer_.queue_.discard();
    }
    EventTimer& timer_;
  };

  template <class Work>
  void time_by_events(double& elapsed_ms, const Work& work) {
    const std::size_t start = mark();
    work();
    pieces_.push_back({start, mark(), &elapsed_ms});
  }
  template <class Work>
  void time_by_clock(double& elapsed_ms, const Work& work) {
    const Inside inside(*this);
    pieces_.clear();
    marks_ = 0;
    const auto start = std::chrono::steady_clock::now();
    work();
    queue_.finish();
    elapsed_ms += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    for (const Piece& piece : pieces_)
      *piece.elapsed_ms += events_[piece.stop].ms_since(events_[piece.start]);
  }
  std::size_t mark() {
    if (marks_ == events_.size()) events_.emplace_back(Event::Kind::timed);
    queue_.mark(events_[marks_]);
    return marks_++;
  }

  WorkQueue& queue_;
  std::vector<Event> events_;  ///< made once, used again for every frame
  std::size_t marks_ = 0;
  std::vector<Piece> pieces_;
  bool is_inside_ = false;
};

}  // namespace facet
