#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/image.hpp"

namespace facet {

/// Number of pixels that two labels share; labels count from 0.
struct Overlap {
  int a = 0, b = 0;
  int px = 0;
};

/// All pairs of labels that share pixels, by a, then b. In the images a label k stands as k + 1, 0 = none.
template <class A, class B>
std::vector<Overlap> count_overlaps(const Image<A>& a, const Image<B>& b) {
  std::unordered_map<std::uint64_t, int> counts;
  for (int y = 0; y < a.height(); ++y) {
    const A* row_a = a.row(y);
    const B* row_b = b.row(y);
    for (int x = 0, start = 0; x < a.width(); x = start) {
      const A in_a = row_a[x];
      const B in_b = row_b[x];
      while (start < a.width() && row_a[start] == in_a && row_b[start] == in_b) ++start;
      if (in_a != 0 && in_b != 0)
        counts[static_cast<std::uint64_t>(in_a) << 32 | static_cast<std::uint32_t>(in_b)] += start - x;
    }
  }
  std::vector<Overlap> overlaps;
  for (const auto& [key, px] : counts)
    overlaps.push_back({static_cast<int>(key >> 32) - 1, static_cast<int>(key & 0xFFFFFFFFu) - 1, px});
  std::sort(overlaps.begin(), overlaps.end(),
            [](const Overlap& l, const Overlap& r) { return l.a != r.a ? l.a < r.a : l.b < r.b; });
  return overlaps;
}

}  // namespace facet
