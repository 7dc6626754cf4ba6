#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <memory>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <vector>

#include "core/clones.hpp"
#include "core/host_threads.hpp"
#include "core/image.hpp"
#include "core/sparse_row.hpp"
#include "cpu/scratch.hpp"

namespace facet {

/// Runs pixel operations on the CPU, in row bands when it has more than one thread. The loop is split into an
/// interior that reads without border tests, so that it vectorises, and a guarded border; results depend
/// neither on the split nor on the number of threads.
///
/// A pixel operation `op` is a trivially copyable struct with `radius` (how far it reads) and
/// `op(x, y, access)`; it writes its own pixel only.
class CpuExecutor : public HostThreads {
 public:
  template <class T>
  using Image = facet::Image<T>;

  explicit CpuExecutor(int threads = 1) : HostThreads(threads), arena_(threads) {}

  /// op(x, y, access) for every pixel.
  template <class Op>
  void for_each_pixel(Size size, const Op& op) {
    for_each_band(size.height, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) run_row(op, size, y);
    });
  }

  /// op(x, y, access) for every pixel that is non-zero in `mask`; for sparse masks. The operation may clear
  /// its own pixel of the mask, nothing else of it.
  template <class Op>
  void for_each_set(ImageView<std::uint8_t> mask, const Op& op) {
    for_each_band(mask.height, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) run_set_row(op, mask, y);
    });
  }

  template <class Op>
  void for_each_set(const BitMask& mask, const Op& op) {
    const Size size = mask.size();
    for_each_band(size.height, [&](int begin, int end) {
      for (int y = begin; y < end; ++y)
        for_each_set_in_row(mask, y, [&](int x) { run_pixel(op, size, x, y); });
    });
  }

  /// op(x, y, access) for one pixel.
  template <class Op>
  [[gnu::always_inline]] static void run_pixel(const Op& op, Size size, int x, int y) {
    const int r = op.radius;
    if (x >= r && y >= r && x < size.width - r && y < size.height - r)
      op(x, y, InteriorAccess{});
    else
      op(x, y, GuardedAccess{});
  }

  /// Sum over all pixels of the integer op(x, y): exact, so the order does not matter.
  template <class Op>
  std::int64_t sum_pixels(Size size, const Op& op) {
    std::int64_t sum = 0;
    for (int y = 0; y < size.height; ++y) sum += sum_row(op, size.width, y);
    return sum;
  }

  template <class T>
  void copy(ImageView<const T> from, ImageView<T> to) {
    for_each_row(from.height, [&](int y) {
      std::memcpy(to.row(y), from.row(y), sizeof(T) * static_cast<std::size_t>(from.width));
    });
  }
  /// Host memory to the executor's and back; on_host: where the host may read an image, which is there sooner
  /// when it was fetched together with others.
  template <class T>
  void upload(ImageView<const T> host, ImageView<T> image) {
    copy(host, image);
  }
  template <class T>
  void download(ImageView<T> image, ImageView<T> host) {
    copy(ImageView<const T>(image), host);
  }
  template <class T>
  ImageView<const T> on_host(const Image<T>& image) {
    return image.view();
  }
  template <class... T>
  void fetch(const Image<T>&...) {}
  template <class T>
  void fill(ImageView<T> image, T value) {
    for_each_row(image.height, [&](int y) { std::fill_n(image.row(y), image.width, value); });
  }

  /// Flag that operations of an iterated pass raise when they changed something.
  int* changed_flag() { return &changed_; }
  bool take_changed() {
    const bool changed = changed_ != 0;
    changed_ = 0;
    return changed;
  }

  /// Runs `work` and adds its wall time [ms] to `elapsed_ms`.
  template <class Work>
  void timed(double& elapsed_ms, const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    elapsed_ms += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }

  /// Memory for the tuned stages.
  CpuScratch& scratch() { return scratch_; }

 private:
  void run(int count, const Task& task) override {
    arena_.execute([&] {
      tbb::parallel_for(0, count, [&](int i) { task(i, tbb::this_task_arena::current_thread_index()); });
    });
  }

  template <class Op>
  FACET_CPU_CLONES static std::int64_t sum_row(const Op& shared_op, int width, int y) {
    const Op op = shared_op;
    std::int64_t sum = 0;
    for (int x = 0; x < width; ++x) sum += op(x, y);
    return sum;
  }

  /// Flattened: an operation that is called, not inlined, is no vector loop, and how much the compiler
  /// inlines by itself depends on what else is in the file.
  template <class Op>
  FACET_CPU_CLONES [[gnu::flatten]] static void run_row(const Op& shared_op, Size size, int y) {
    const Op op = shared_op;  // a local copy: its views cannot alias what it writes
    const int r = op.radius;
    const bool inside = y >= r && y < size.height - r && size.width > 2 * r;
    const int begin = inside ? r : size.width;
    const int end = inside ? size.width - r : size.width;
    for (int x = 0; x < begin; ++x) op(x, y, GuardedAccess{});
#pragma GCC ivdep
    for (int x = begin; x < end; ++x) op(x, y, InteriorAccess{});
    for (int x = end; x < size.width; ++x) op(x, y, GuardedAccess{});
  }

  template <class Op>
  static void run_set_row(const Op& op, ImageView<std::uint8_t> mask, int y) {
    for_each_set_in_row(mask.row(y), mask.width, [&](int x) { run_pixel(op, mask.size(), x, y); });
  }

  tbb::task_arena arena_;
  int changed_ = 0;
  CpuScratch scratch_;
};

}  // namespace facet
