#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>

#include "cuda/passes_ahead.hpp"
#include "support/shuffled_grid.hpp"

namespace facet {

/// Memory that only the emulated device may touch: who else does dies of a segmentation fault. It is never
/// given back.
class DeviceArena {
 public:
  static DeviceArena& instance() {
    static DeviceArena arena;
    return arena;
  }
  /// Open while the device works.
  class Access {
   public:
    Access() { instance().protect(PROT_READ | PROT_WRITE); }
    ~Access() { instance().protect(PROT_NONE); }
    Access(const Access&) = delete;
    Access& operator=(const Access&) = delete;
  };
  void* allocate(std::size_t bytes) {
    const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    void* start = base_ + used_;
    used_ += (bytes + page - 1) / page * page;
    if (used_ > size) throw std::runtime_error("the emulated device is out of memory");
    return start;
  }

 private:
  static constexpr std::size_t size = std::size_t{1} << 30;
  DeviceArena() {
    void* mapped = ::mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (mapped == MAP_FAILED) throw std::runtime_error("mmap failed");
    base_ = static_cast<std::byte*>(mapped);
  }
  void protect(int rights) const {
    if (used_ > 0) ::mprotect(base_, used_, rights);
  }
  std::byte* base_ = nullptr;
  std::size_t used_ = 0;
};

/// An image in the memory of the emulated device, with a copy for the host that is taken when asked for.
template <class T>
class EmulatedDeviceImage {
 public:
  void resize(Size size) {
    if (size == size_) return;
    size_ = size.empty() ? Size{} : size;
    stride_ = (size_.width + 31) / 32 * 32;
    data_ = static_cast<T*>(DeviceArena::instance().allocate(sizeof(T) * stride_ * size_.height));
    taken_at_ = -1;
  }
  Size size() const { return size_; }
  ImageView<T> view() { return {data_, size_.width, size_.height, stride_}; }
  ImageView<const T> view() const { return {data_, size_.width, size_.height, stride_}; }
  /// As DeviceImage::host_copy.
  ImageView<const T> host_copy(long work) const {
    if (taken_at_ != work) {
      const DeviceArena::Access access;
      host_.resize(size_);
      for (int y = 0; y < size_.height; ++y)
        for (int x = 0; x < size_.width; ++x) host_(x, y) = view()(x, y);
      taken_at_ = work;
    }
    return host_.view();
  }

 private:
  T* data_ = nullptr;
  Size size_;
  int stride_ = 0;
  mutable Image<T> host_;
  mutable long taken_at_ = -1;
};

/// A shuffled grid that is as strange to the host as CudaExecutor is: its images lie in memory of their own,
/// copies for the host are taken anew only where work was done since, and iterated stages pass a few times
/// more than they need to.
class EmulatedDevice {
 public:
  template <class T>
  using Image = EmulatedDeviceImage<T>;

  explicit EmulatedDevice(unsigned seed = 1) : grid_(seed) {}

  template <class Op>
  void for_each_pixel(Size size, const Op& op) {
    work([&] { grid_.for_each_pixel(size, op); });
  }
  template <class Op>
  void for_each_set(ImageView<std::uint8_t> mask, const Op& op) {
    work([&] { grid_.for_each_set(mask, op); });
  }
  template <class Op>
  std::int64_t sum_pixels(Size size, const Op& op) {
    const DeviceArena::Access access;
    return grid_.sum_pixels(size, op);
  }
  template <class T>
  void copy(ImageView<const T> from, ImageView<T> to) {
    work([&] { grid_.copy(from, to); });
  }
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
    return image.host_copy(work_);
  }
  template <class T>
  void fill(ImageView<T> image, T value) {
    work([&] { grid_.fill(image, value); });
  }
  int* changed_flag() {
    passes_.begin();
    return &changed_;
  }
  bool take_changed() {
    if (!passes_.is_open()) {
      passes_.restart();
      return false;
    }
    answers_[static_cast<std::size_t>(passes_.end())] = changed_;
    changed_ = 0;
    const auto due = passes_.due();
    return !due || answers_[static_cast<std::size_t>(*due)] != 0;
  }
  template <class Work>
  void timed(double&, const Work& work) {
    work();
  }

 private:
  template <class Work>
  void work(const Work& work) {
    const DeviceArena::Access access;
    work();
    ++work_;
  }

  ShuffledGridExecutor grid_;
  long work_ = 0;
  int changed_ = 0;
  PassesAhead passes_;
  std::array<int, PassesAhead::slots> answers_{};
};

}  // namespace facet
