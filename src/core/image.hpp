#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>

#include "core/image_view.hpp"

namespace facet {

/// Owning host image, row-major, rows padded to 64 bytes. Its memory is kept when it shrinks, so an image
/// that is resized to the same size for every frame allocates once.
template <class T>
class Image {
 public:
  using value_type = T;

  Image() = default;
  explicit Image(Size size) { resize(size); }
  Image(Size size, T value) : Image(size) { fill(value); }
  Image(const Image& other) : Image(other.size()) {
    std::copy_n(other.storage_.get(), element_count(), storage_.get());
  }
  Image& operator=(const Image& other) {
    if (this != &other) {
      resize(other.size());
      std::copy_n(other.storage_.get(), element_count(), storage_.get());
    }
    return *this;
  }
  Image(Image&& other) noexcept { swap(other); }
  Image& operator=(Image&& other) noexcept {
    swap(other);
    return *this;
  }

  /// Sets the size; the contents are undefined afterwards unless the size was the same already.
  void resize(Size size) {
    if (size == size_) return;
    size_ = size.empty() ? Size{} : size;
    stride_ = (size_.width + row_quantum - 1) / row_quantum * row_quantum;
    if (element_count() > capacity_) {
      capacity_ = element_count();
      storage_.reset(new (std::align_val_t{alignment}) T[capacity_]);
    }
    fill(T{});
  }
  void fill(T value) { std::fill_n(storage_.get(), element_count(), value); }
  void swap(Image& other) noexcept {
    std::swap(storage_, other.storage_);
    std::swap(capacity_, other.capacity_);
    std::swap(size_, other.size_);
    std::swap(stride_, other.stride_);
  }

  Size size() const { return size_; }
  int width() const { return size_.width; }
  int height() const { return size_.height; }
  bool empty() const { return size_.empty(); }
  T& operator()(int x, int y) { return storage_[static_cast<std::size_t>(y) * stride_ + x]; }
  const T& operator()(int x, int y) const { return storage_[static_cast<std::size_t>(y) * stride_ + x]; }
  T* row(int y) { return storage_.get() + static_cast<std::size_t>(y) * stride_; }
  const T* row(int y) const { return storage_.get() + static_cast<std::size_t>(y) * stride_; }
  ImageView<T> view() { return {storage_.get(), size_.width, size_.height, stride_}; }
  ImageView<const T> view() const { return {storage_.get(), size_.width, size_.height, stride_}; }
  int stride() const { return stride_; }

 private:
  static constexpr std::size_t alignment = 64;
  static constexpr int row_quantum = sizeof(T) >= alignment ? 1 : static_cast<int>(alignment / sizeof(T));
  struct Deleter {
    void operator()(T* data) const { ::operator delete[](data, std::align_val_t{alignment}); }
  };
  std::size_t element_count() const { return static_cast<std::size_t>(stride_) * size_.height; }

  std::unique_ptr<T[], Deleter> storage_;
  std::size_t capacity_ = 0;
  Size size_;
  int stride_ = 0;
};

}  // namespace facet
