#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "core/image_view.hpp"
#include "cuda/device_image.cuh"
#include "cuda/event_timer.cuh"
#include "cuda/passes_ahead.hpp"
#include "cuda/stream.cuh"

namespace facet {

/// Operation of the pixels that are set in a mask.
template <class Op>
struct WhereSetOp {
  Op op;
  ImageView<const std::uint8_t> mask;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    if (mask(x, y)) op(x, y, access);
  }
};

template <class T>
struct SetOp {
  ImageView<T> image;
  T value;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    image(x, y) = value;
  }
};

/// Images of the tuned stages.
struct DeviceScratch {
  DeviceImage<std::uint16_t> counts;
};

/// Runs pixel operations on a CUDA device in a stream of its own: calls return before the device has done the
/// work, save where the host needs what it yields. Otherwise as CpuExecutor. `Kernels` launches them: on the
/// device, or, in the tests, where the device is emulated. Throws Error{not_measured} where the device cannot
/// (no memory), Error{internal} where a kernel failed.
template <class Kernels>
class StreamExecutor {
 public:
  template <class T>
  using Image = DeviceImage<T>;

  StreamExecutor() : timer_(stream_) {
    words_.reserve(sizeof(DeviceWords));
    host_words_.reserve(sizeof(HostWords));
    check_cuda(cudaMemsetAsync(words_.as<void>(), 0, sizeof(DeviceWords), stream_), "clear a flag");
  }

  /// op(x, y, access) for every pixel.
  template <class Op>
  void for_each_pixel(Size size, const Op& op) {
    if (size.empty()) return;
    Kernels::for_each_pixel(op, size, stream_);
    launched();
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
    check_cuda(cudaMemsetAsync(sum, 0, sizeof *sum, stream_), "clear a sum");
    Kernels::add_up(op, size, sum, stream_);
    launched();
    check_cuda(cudaMemcpyAsync(host_sum, sum, sizeof *sum, cudaMemcpyDeviceToHost, stream_), "read a sum");
    stream_.wait();
    return static_cast<std::int64_t>(*host_sum);
  }

  template <class T>
  void copy(ImageView<const T> from, ImageView<T> to) {
    copy_rows(from, to, cudaMemcpyDeviceToDevice);
  }
  template <class T>
  void fill(ImageView<T> image, T value) {
    for_each_pixel(image.size(), SetOp<T>{image, value});
  }
  /// Host memory to the device's; `host` may change as soon as the call returns.
  template <class T>
  void upload(ImageView<const T> host, ImageView<T> image) {
    uploaded_.wait();  // the last one has left the staging memory
    const ImageView<T> staging = packed<T>(upload_staging_, host);
    copy_on_host(host, staging);
    copy_rows(ImageView<const T>(staging), image, cudaMemcpyHostToDevice);
    uploaded_.record(stream_);
  }
  /// The device's memory to the host's. Waits for the device.
  template <class T>
  void download(ImageView<T> image, ImageView<T> host) {
    const ImageView<T> staging = packed<T>(download_staging_, host);
    copy_rows(ImageView<const T>(image), staging, cudaMemcpyDeviceToHost);
    stream_.wait();
    copy_on_host(ImageView<const T>(staging), host);
  }
  /// Where the host may read an image until the next call that works on the device. Waits for the device.
  template <class T>
  ImageView<const T> on_host(const Image<T>& image) {
    return image.host_copy(work_, stream_);
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
    const auto slot = static_cast<std::size_t>(passes_.end());
    auto& answers = host_words_.as<HostWords>()->changed;
    Kernels::publish_flag(&words_.as<DeviceWords>()->changed, &answers[slot], stream_);
    launched();
    answered_[slot].record(stream_);
    const auto due = passes_.due();
    if (!due) return true;
    answered_[static_cast<std::size_t>(*due)].wait();
    return const_cast<const volatile int&>(answers[static_cast<std::size_t>(*due)]) != 0;
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
  /// What single words the kernels write, on the device and in host memory.
  struct DeviceWords {
    unsigned long long sum;
    int changed;
  };
  struct HostWords {
    unsigned long long sum;
    int changed[PassesAhead::slots];
  };

  void launched() {
    check_cuda(cudaGetLastError(), "launch a kernel");
    ++work_;
  }
  template <class T>
  void copy_rows(ImageView<const T> from, ImageView<T> to, cudaMemcpyKind kind) {
    if (from.size().empty()) return;
    const auto bytes = [](int pixels) { return sizeof(T) * static_cast<std::size_t>(pixels); };
    check_cuda(cudaMemcpy2DAsync(to.data, bytes(to.stride), from.data, bytes(from.stride), bytes(from.width),
                                 static_cast<std::size_t>(from.height), kind, stream_),
               "copy an image");
    if (kind != cudaMemcpyDeviceToHost) ++work_;
  }
  /// Pinned memory laid out for an image.
  template <class T, class Pixel>
  static ImageView<T> packed(PinnedMemory& memory, ImageView<Pixel> like) {
    memory.reserve(sizeof(T) * static_cast<std::size_t>(like.size().area()));
    return {memory.template as<T>(), like.width, like.height, like.width};
  }
  template <class T>
  static void copy_on_host(ImageView<const T> from, ImageView<T> to) {
    for (int y = 0; y < from.height; ++y)
      std::memcpy(to.row(y), from.row(y), sizeof(T) * static_cast<std::size_t>(from.width));
  }

  Stream stream_;
  EventTimer timer_;
  std::uint64_t work_ = 0;  ///< tells how old a copy for the host is
  DeviceMemory words_;
  PinnedMemory host_words_, upload_staging_, download_staging_;
  Event uploaded_;
  DeviceScratch scratch_;
  PassesAhead passes_;
  std::array<Event, PassesAhead::slots> answered_;
};

}  // namespace facet
