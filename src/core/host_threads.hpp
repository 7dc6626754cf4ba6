#pragma once

#include <algorithm>
#include <cstddef>

namespace facet {

/// Threads among which work on the host is shared out; by itself, the calling one alone. What it does depends
/// on the pieces of work, never on how many threads there are.
class HostThreads {
 public:
  HostThreads() = default;
  HostThreads(const HostThreads&) = delete;
  HostThreads& operator=(const HostThreads&) = delete;
  virtual ~HostThreads() = default;

  /// How many pieces of work may run at the same time.
  int workers() const { return workers_; }

  /// work(i, worker) for i = 0 ... count - 1, in any order; `worker`, less than workers(), tells apart what
  /// may run at the same time.
  template <class Work>
  void share_out(int count, const Work& work) {
    if (workers_ == 1 || count == 1) {
      for (int i = 0; i < count; ++i) work(i, 0);
      return;
    }
    run(count, {&work, [](const void* its_work, int i, int worker) {
                  (*static_cast<const Work*>(its_work))(i, worker);
                }});
  }

  /// part(i, begin, end) for consecutive parts of `count` things, at most one for each worker and none of
  /// less than `least`, which would not be worth it.
  template <class Part>
  void for_each_part(std::size_t count, std::size_t least, const Part& part) {
    const std::size_t parts = std::clamp<std::size_t>(count / least, 1, static_cast<std::size_t>(workers_));
    share_out(static_cast<int>(parts), [&](int index, int) {
      const auto i = static_cast<std::size_t>(index);
      part(i, count * i / parts, count * (i + 1) / parts);
    });
  }

  /// band(begin, end) for bands of rows, a few for each thread, so that one that begins late has less to do.
  template <class Band>
  void for_each_band(int rows, const Band& band) {
    if (workers_ == 1) return band(0, rows);
    const int bands = 4 * workers_;
    share_out(bands, [&](int i, int) { band(rows * i / bands, rows * (i + 1) / bands); });
  }

  /// work(y) for every row.
  template <class Work>
  void for_each_row(int rows, const Work& work) {
    for_each_band(rows, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) work(y);
    });
  }

 protected:
  /// A piece of work of any type.
  struct Task {
    const void* work;
    void (*call)(const void* work, int i, int worker);
    void operator()(int i, int worker) const { call(work, i, worker); }
  };
  explicit HostThreads(int workers) : workers_(workers) {}

 private:
  /// task(i, worker) for i = 0 ... count - 1; asked of more than one worker only.
  virtual void run(int count, const Task& task) {
    for (int i = 0; i < count; ++i) task(i, 0);
  }

  int workers_ = 1;
};

}  // namespace facet
