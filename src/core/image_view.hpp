#pragma once

#include <cstddef>
#include <type_traits>

#include "core/host_device.hpp"

namespace facet {

/// Image size in pixels.
struct Size {
  int width = 0;
  int height = 0;

  FACET_HD bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  FACET_HD bool empty() const { return width <= 0 || height <= 0; }
  FACET_HD std::ptrdiff_t area() const { return static_cast<std::ptrdiff_t>(width) * height; }
  friend bool operator==(const Size&, const Size&) = default;
};

/// Non-owning view of a row-major image in host or device memory; trivially copyable.
/// x runs right, y down, pixel centres lie at integer coordinates. `stride` counts elements between rows.
template <class T>
struct ImageView {
  T* data = nullptr;
  int width = 0;
  int height = 0;
  int stride = 0;

  FACET_HD T& operator()(int x, int y) const { return data[static_cast<std::ptrdiff_t>(y) * stride + x]; }
  FACET_HD T* row(int y) const { return data + static_cast<std::ptrdiff_t>(y) * stride; }
  FACET_HD Size size() const { return {width, height}; }
  template <class U>
  requires(!std::is_const_v<T> && std::is_same_v<U, const T>) FACET_HD operator ImageView<U>() const {
    return {data, width, height, stride};
  }
};

/// Border rules. A pixel operation reads its neighbours through one of these policies, so that the executor
/// can hand it `InteriorAccess` (no tests, vectorisable) where its whole neighbourhood lies inside the image,
/// and `GuardedAccess` everywhere else. Both give the same values wherever both may be used.
struct InteriorAccess {
  template <class T>
  FACET_HD T clamped(const ImageView<T>& image, int x, int y) const {
    return image(x, y);
  }
  template <class T>
  FACET_HD T or_zero(const ImageView<T>& image, int x, int y) const {
    return image(x, y);
  }
};

struct GuardedAccess {
  /// The nearest pixel of the image.
  template <class T>
  FACET_HD T clamped(const ImageView<T>& image, int x, int y) const {
    const int cx = x < 0 ? 0 : (x >= image.width ? image.width - 1 : x);
    const int cy = y < 0 ? 0 : (y >= image.height ? image.height - 1 : y);
    return image(cx, cy);
  }
  /// The pixel, or zero outside the image.
  template <class T>
  FACET_HD auto or_zero(const ImageView<T>& image, int x, int y) const {
    using Value = decltype(T{} + T{});
    return image.size().contains(x, y) ? static_cast<Value>(image(x, y)) : Value{};
  }
};

}  // namespace facet
