#pragma once

#include <cstdint>

#include "core/image_view.hpp"
#include "core/neighbours.hpp"
#include "stage/ridge.hpp"

namespace facet {

/// Keeps local maxima of strength across the edge. Of two equal neighbours the earlier one stays, so that a
/// plateau of two pixels, the response to an ideal step, becomes one line without gaps.
struct NonMaxSuppressionOp {
  static constexpr int radius = 1;
  ImageView<const float> strength;
  ImageView<const std::uint8_t> direction;
  float low, high;
  ImageView<std::uint8_t> ridge;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    const float s = strength(x, y);
    const int across = direction(x, y);
    float before = 0, after = 0;  // the four pairs are all read and one is kept: no branches
    FACET_UNROLL for (int i = 0; i < 4; ++i) {
      const Offset d = direction4(i);
      const float b = access.or_zero(strength, x - d.dx, y - d.dy);
      const float a = access.or_zero(strength, x + d.dx, y + d.dy);
      before = across == i ? b : before;
      after = across == i ? a : after;
    }
    const bool is_max = (s > low) & (s > before) & (s >= after);
    const int kept = s > high ? static_cast<int>(Ridge::strong) : static_cast<int>(Ridge::weak);
    ridge(x, y) = static_cast<std::uint8_t>(is_max ? kept : 0);
  }
};

/// Canny's second step (paper section 4.2.1): ridges of `strength` along `direction` (a direction4 per pixel,
/// across the edge), split by two thresholds in the unit of `strength`.
template <class Executor>
void non_max_suppression(Executor& executor, ImageView<const float> strength,
                         ImageView<const std::uint8_t> direction, float low, float high,
                         ImageView<std::uint8_t> ridge) {
  executor.for_each_pixel(strength.size(), NonMaxSuppressionOp{strength, direction, low, high, ridge});
}

}  // namespace facet
