#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "core/host_threads.hpp"
#include "core/image.hpp"
#include "core/launch.hpp"

namespace facet {

/// Executor that emulates a device launch on the CPU: every thread of the grid runs, those beyond the image's
/// edge too, in shuffled order and under the guarded border rule. What gives other results here than on the
/// CPU executor depends on the order of threads or misses its guard. What is shared out on the host is
/// shuffled as well.
class ShuffledGridExecutor : public HostThreads {
 public:
  template <class T>
  using Image = facet::Image<T>;

  explicit ShuffledGridExecutor(unsigned seed = 1) : HostThreads(3), engine_(seed) {}

  template <class Op>
  void for_each_pixel(Size size, const Op& op) {
    const int width = Launch::blocks_x(size) * Launch::block_width;
    const int height = Launch::blocks_y(size) * Launch::block_height;
    shuffle(width * height);
    for (const int i : order_) run_pixel_thread(op, size, i % width, i / width);
  }
  template <class Op>
  void for_each_set(ImageView<std::uint8_t> mask, const Op& op) {
    const Image<std::uint8_t> before = snapshot(mask);
    shuffle(static_cast<int>(mask.size().area()));
    for (const int i : order_)
      if (before(i % mask.width, i / mask.width)) op(i % mask.width, i / mask.width, GuardedAccess{});
  }
  template <class Op>
  std::int64_t sum_pixels(Size size, const Op& op) {
    std::int64_t sum = 0;
    shuffle(static_cast<int>(size.area()));
    for (const int i : order_) sum += op(i % size.width, i / size.width);
    return sum;
  }
  template <class T>
  void copy(ImageView<const T> from, ImageView<T> to) {
    for (int y = 0; y < from.height; ++y)
      for (int x = 0; x < from.width; ++x) to(x, y) = from(x, y);
  }
  /// Host memory to the executor's and back; on_host: where the host may read an image.
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
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) image(x, y) = value;
  }
  int* changed_flag() { return &changed_; }
  bool take_changed() {
    const bool changed = changed_ != 0;
    changed_ = 0;
    return changed;
  }
  template <class Work>
  void timed(double&, const Work& work) {
    work();
  }

 private:
  void run(int count, const Task& task) override {
    shuffle(count);
    const std::vector<int> order = order_;
    for (const int i : order) task(i, i % workers());
  }
  static Image<std::uint8_t> snapshot(ImageView<std::uint8_t> view) {
    Image<std::uint8_t> copy(view.size());
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) copy(x, y) = view(x, y);
    return copy;
  }
  void shuffle(int count) {
    order_.resize(count);
    for (int i = 0; i < count; ++i) order_[i] = i;
    std::shuffle(order_.begin(), order_.end(), engine_);
  }

  std::mt19937 engine_;
  std::vector<int> order_;
  int changed_ = 0;
};

}  // namespace facet
