#pragma once

#include <cstring>
#include <gtest/gtest.h>
#include <tuple>
#include <type_traits>

#include "core/image.hpp"

namespace facet {

/// Whether two images have the same size and the same pixels, to the bit; the padding of rows does not count.
/// The failure names the first pixel that differs.
template <class T>
testing::AssertionResult same_image(const Image<T>& a, const Image<T>& b) {
  if (a.size() != b.size()) return testing::AssertionFailure() << "sizes differ";
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      if (std::memcmp(&a(x, y), &b(x, y), sizeof(T)) == 0) continue;
      auto failure = testing::AssertionFailure()
                     << a.width() << "x" << a.height() << ", pixel (" << x << ", " << y << ")";
      if constexpr (std::is_arithmetic_v<T>) failure << ": " << +a(x, y) << " against " << +b(x, y);
      return failure;
    }
  return testing::AssertionSuccess();
}

/// The same for what a stage writes into several images.
template <class... T>
testing::AssertionResult same_image(const std::tuple<Image<T>...>& a, const std::tuple<Image<T>...>& b) {
  testing::AssertionResult result = testing::AssertionSuccess();
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((result = result ? same_image(std::get<i>(a), std::get<i>(b)) << ", image " << i : result), ...);
  }
  (std::index_sequence_for<T...>{});
  return result;
}

}  // namespace facet
