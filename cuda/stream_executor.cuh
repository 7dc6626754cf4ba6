#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

#include "core/host_threads.hpp"
#include "core/launch.hpp"
#include "cuda/device_image.cuh"
#include "cuda/event_timer.cuh"
#include "cuda/image_ops.hpp"
#include "cuda/passes_ahead.hpp"
#include "cuda/tuned/region_table.hpp"
#include "cuda/work_queue.cuh"

namespace facet {

/// Images of the tuned stages.
struct DeviceScratch {
  DeviceImage<std::uint16_t> counts;
  RegionTable<DeviceImage> regions;
};

/// Runs pixel operations on a CUDA device: calls return before the device has done the work, or begun it (see
/// WorkQueue), save where the host needs what it yields. Otherwise as CpuExecutor. `Kernels` are those of the
/// device or, in the tests, where the device is emulated, what stands for them. Throws Error{not_measured}
/// where the device cannot (no memory), Error{internal} where a kernel failed.
template <class Kernels>
class StreamExecutor : public HostThreads {
 public:
  template <class T>
  using Image = DeviceImage<T>;

  /// `host_threads`: for what is shared out on the host; by itself the calling one alone.
  explicit StreamExecutor(std::shared_ptr<HostThreads> host_threads = std::make_shared<HostThreads>())
      : HostThreads(host_threads->workers()), host_threads_(std::move(host_threads)), timer_(queue_) {
    words_.reserve(sizeof(DeviceWords));
    host_words_.reserve(sizeof(HostWords));
    fill(word(&words_.as<DeviceWords>()->changed), 0);
    queue_.give();
  }

  /// op(x, y, access) for every pixel.
  template <class Op>
  void for_each_pixel(Size size, const Op& op) {
    if (!size.empty()) call(Kernels::template for_each_pixel<Op>(), blocks(size), threads(), op, size);
  }
  /// op(x, y, access) for every pixel that is non-zero in `mask`. The operation may clear its own pixel of
  /// the mask, nothing else of it.
  template <class Op>
  void for_each_set(ImageView<std::uint8_t> mask, const Op& op) {
    for_each_pixel(mask.size(), WhereSetOp<Op>{op, mask});
  }
  /// Sum over all pixels of the integer op(x, y). Waits for the device.
  template <class Op>
  std::int64_t sum_pixels(Size size, const Op& op) {
    if (size.empty()) return 0;
    auto* sum = &words_.as<DeviceWords>()->sum;
    auto* host_sum = &host_words_.as<HostWords>()->sum;
    fill(word(sum), 0ull);
    call(Kernels::template add_up<Op>(), blocks(size), threads(), op, size, sum);
    queue_.copy(host_sum, sum, sizeof *sum, cudaMemcpyDeviceToHost);
    queue_.finish();
    return static_cast<std::int64_t>(*host_sum);
  }

  template <class T>
  void copy(ImageView<const T> from, ImageView<T> to) {
    for_each_pixel(from.size(), CopyOp<T>{from, to});
  }
  template <class T>
  void fill(ImageView<T> image, T value) {
    for_each_pixel(image.size(), SetOp<T>{image, value});
  }
  /// Host memory to the device's, all of an image; `host` may change as soon as the call returns.
  template <class T>
  void upload(ImageView<const T> host, ImageView<T> image) {
    if (host.size().empty()) return;
    if (uploaded_at_ == queue_.times_finished()) queue_.finish();  // the last one leaves the staging memory
    const ImageView<T> staging = staged(upload_staging_, image);
    copy_on_host(host, staging);
    queue_.copy(image.data, staging.data, bytes_of(image), cudaMemcpyHostToDevice);
    uploaded_at_ = queue_.times_finished();
    ++work_;
  }
  /// The device's memory, all of an image, to the host's. Waits for the device.
  template <class T>
  void download(ImageView<T> image, ImageView<T> host) {
    if (host.size().empty()) return;
    const ImageView<T> staging = staged(download_staging_, image);
    queue_.copy(staging.data, image.data, bytes_of(image), cudaMemcpyDeviceToHost);
    queue_.finish();
    copy_on_host(ImageView<const T>(staging), host);
  }
  /// Where the host may read an image until the next call that works on the device. Waits for the device.
  template <class T>
  ImageView<const T> on_host(const Image<T>& image) {
    fetch(image);
    return image.host_view();
  }
  /// Copies several images to the host at once, where on_host() finds them. Waits for the device.
  template <class... T>
  void fetch(const Image<T>&... images) {
    if ((static_cast<int>(images.ask_for_copy(work_, queue_)) + ...) > 0) queue_.finish();
  }

  /// Flag that operations of an iterated pass raise when they changed something.
  int* changed_flag() {
    passes_.begin();
    return &words_.as<DeviceWords>()->changed;
  }
  /// Whether the stage has to go on: it may have to pass a few more times than is needed (see PassesAhead).
  /// Without a flag handed out since the last call it begins anew.
  bool take_changed() {
    if (!passes_.is_open()) {
      passes_.restart();
      return false;
    }
    int* answers = host_words_.as<HostWords>()->changed;
    call(Kernels::publish_flag(), 1, 1, &words_.as<DeviceWords>()->changed, answers + passes_.end());
    if (passes_.is_to_give()) queue_.give(answered_[passes_.last() % answered_.size()]);
    const auto due = passes_.due();
    if (!due) return true;
    answered_[*due % answered_.size()].wait();
    const auto has_changed = [&](std::size_t pass) {
      return const_cast<const volatile int&>(answers[pass % PassesAhead::slots]) != 0;
    };
    if (has_changed(*due)) return true;
    passes_.ended(*due, has_changed);
    return false;
  }

  /// Runs `work` and adds its time [ms] to `elapsed_ms`, which must last until the outermost call ends; when
  /// that does, the device has done all its work.
  template <class Work>
  void timed(double& elapsed_ms, const Work& work) {
    timer_.time(elapsed_ms, work);
  }

  /// Memory for the tuned stages.
  DeviceScratch& scratch() { return scratch_; }

  /// Kernels and copies that may have changed the device's memory so far.
  std::uint64_t work_given() const { return work_; }

 private:
  void run(int count, const Task& task) override { host_threads_->share_out(count, task); }

  /// What single words the kernels write, on the device and in host memory.
  struct DeviceWords {
    unsigned long long sum;
    int changed;
  };
  struct HostWords {
    unsigned long long sum;
    int changed[PassesAhead::slots];
  };

  static dim3 threads() { return {Launch::block_width, Launch::block_height}; }
  static dim3 blocks(Size size) {
    return {static_cast<unsigned>(Launch::blocks_x(size)), static_cast<unsigned>(Launch::blocks_y(size))};
  }
  template <class... Arguments>
  void call(const void* kernel, dim3 blocks, dim3 threads, const Arguments&... arguments) {
    passes_.note_kernel(kernel);
    queue_.call(kernel, blocks, threads, arguments...);
    ++work_;
  }
  template <class T>
  static ImageView<T> word(T* word) {
    return {word, 1, 1, 1};
  }
  template <class T>
  static std::size_t bytes_of(ImageView<T> image) {
    return sizeof(T) * static_cast<std::size_t>(image.stride) * static_cast<std::size_t>(image.height);
  }
  /// Pinned memory laid out as an image, so that it is copied in one piece.
  template <class T>
  static ImageView<T> staged(PinnedMemory& memory, ImageView<T> like) {
    memory.reserve(bytes_of(like));
    return {memory.template as<T>(), like.width, like.height, like.stride};
  }
  template <class T>
  static void copy_on_host(ImageView<const T> from, ImageView<T> to) {
    for (int y = 0; y < from.height; ++y)
      std::memcpy(to.row(y), from.row(y), sizeof(T) * static_cast<std::size_t>(from.width));
  }

  std::uint64_t work_ = 0;  ///< tells how old a copy for the host is
  std::shared_ptr<HostThreads> host_threads_;
  DeviceMemory words_;
  PinnedMemory host_words_, upload_staging_, download_staging_;
  std::optional<std::uint64_t> uploaded_at_;
  PassesAhead passes_;
  std::array<Event, PassesAhead::count + 1> answered_;
  DeviceScratch scratch_;
  WorkQueue queue_;
  EventTimer timer_;
};

}  // namespace facet
