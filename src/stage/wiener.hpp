#pragma once

#include <cstdint>
#include <type_traits>

#include "core/depth_noise.hpp"
#include "core/image_view.hpp"

namespace facet {

enum class WienerGain {
  paper,  ///< eq. 2 as printed: var / (var + noise)
  lim,    ///< Lim 1990: max(0, var - noise) / max(var, noise)
};
enum class WienerNoise {
  sensor,  ///< the sensor's noise model at the pixel's depth
  mean,    ///< mean of all local variances (the paper)
};

struct WienerParams {
  bool enabled = true;
  WienerGain gain = WienerGain::lim;
  WienerNoise noise = WienerNoise::sensor;
  int window_px = 5;    ///< side of the square window, odd [px], 3..7
  bool detrend = true;  ///< subtract the local plane's slope from the variance, so that a slope is not signal
};

/// Mean and variance of the valid pixels in a (2 Radius + 1)^2 window, the variance about the local mean (two
/// passes: no cancellation at 4 m) or, detrended, about the window's least-squares plane. A pixel that is
/// missing or has fewer than five valid neighbours gets variance -1: it passes through unfiltered.
template <int Radius, bool detrend>
struct WienerStatisticsOp {
  static constexpr int radius = Radius;
  static constexpr int side = 2 * Radius + 1;
  static constexpr int min_valid = 5;
  ImageView<const float> depth_m;
  ImageView<float> mean_m, variance_m2;

  /// Sums column by column, so that windows beside each other can share their columns.
  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    float sum = 0;
    int n = 0;
    FACET_UNROLL for (int dx = -Radius; dx <= Radius; ++dx) {
      float column = 0;
      FACET_UNROLL for (int dy = -Radius; dy <= Radius; ++dy) {
        const float z = access.clamped(depth_m, x + dx, y + dy);
        n += z > 0 ? 1 : 0;
        column += z;
      }
      sum += column;
    }
    finish(x, y, sum, n, access);
  }

  /// The second pass: `sum` of the depths of the window's `n` valid pixels -> mean and variance.
  template <class Access>
  FACET_HD void finish(int x, int y, float sum, int n, Access access) const {
    const float count = static_cast<float>(n > 0 ? n : 1);
    const float mean = sum / count;
    float squares = 0;
    float rows[side] = {}, columns[side] = {};  // sums of the differences from the mean
    FACET_UNROLL for (int j = 0; j < side; ++j) {
      float row_squares = 0;
      FACET_UNROLL for (int i = 0; i < side; ++i) {
        const float z = access.clamped(depth_m, x + i - Radius, y + j - Radius);
        const float d = z > 0 ? z - mean : 0.0f;
        row_squares += d * d;
        rows[j] += d;
        columns[i] += d;
      }
      squares += row_squares;
    }
    const float residual = squares - (detrend ? explained_by_slope(columns, rows) : 0.0f);
    mean_m(x, y) = mean;
    variance_m2(x, y) =
        n >= min_valid && depth_m(x, y) > 0 ? (residual > 0 ? residual : 0.0f) / count : -1.0f;
  }

 private:
  /// Sum of squares that the least-squares plane of a full window explains; with holes its slope is slightly
  /// damped.
  FACET_HD static float explained_by_slope(const float (&columns)[side], const float (&rows)[side]) {
    constexpr float spread = side * side * Radius * (Radius + 1) / 3.0f;  // sum of dx^2 over the window
    float along_x = 0, along_y = 0;
    FACET_UNROLL for (int k = 1; k <= Radius; ++k) {
      along_x += static_cast<float>(k) * (columns[Radius + k] - columns[Radius - k]);
      along_y += static_cast<float>(k) * (rows[Radius + k] - rows[Radius - k]);
    }
    return (along_x * along_x + along_y * along_y) / spread;
  }
};

/// Variances as integers, so that their sum is exact in any order: unit 1e-9 m^2, i.e. (32 um)^2, at most 1
/// m^2.
struct WienerVarianceSum {
  static constexpr float units_per_m2 = 1e9f;
  ImageView<const float> variance_m2;

  FACET_HD std::int32_t operator()(int x, int y) const {
    const float v = variance_m2(x, y);
    const auto units = static_cast<std::int32_t>((v < 1 ? v : 1.0f) * units_per_m2 + 0.5f);
    return units > 0 ? units : 0;  // -1 m^2 is no variance
  }
};
struct WienerVarianceCount {
  ImageView<const float> variance_m2;
  FACET_HD std::int32_t operator()(int x, int y) const { return variance_m2(x, y) >= 0 ? 1 : 0; }
};

/// Pulls each depth towards its local mean by how much of the local variance is noise.
struct WienerApplyOp {
  static constexpr int radius = 0;
  ImageView<const float> depth_m, mean_m, variance_m2;
  WienerGain gain;
  bool use_sensor;
  DepthNoise sensor;
  float noise_m2;  ///< noise variance where the sensor model is not used
  ImageView<float> out;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const float z = depth_m(x, y);
    const float variance = variance_m2(x, y);
    const float sigma = sensor.sigma_m(z);
    const float noise = use_sensor ? sigma * sigma : noise_m2;
    const float excess = variance - noise;
    const float larger = variance > noise ? variance : noise;
    const float lim = (excess > 0 ? excess : 0.0f) / (larger > 0 ? larger : 1.0f);
    const float sum = variance + noise;
    const float printed = sum > 0 ? variance / sum : 1.0f;
    const float g = gain == WienerGain::lim ? lim : printed;
    const float mean = mean_m(x, y);
    out(x, y) = variance < 0 ? z : mean + g * (z - mean);
  }
};

/// work(radius, detrend) with the parameters' values as constants.
template <class Work>
void with_window(const WienerParams& params, const Work& work) {
  const auto with_radius = [&](auto radius) {
    if (params.detrend)
      work(radius, std::true_type{});
    else
      work(radius, std::false_type{});
  };
  switch (params.window_px / 2) {
    case 1:
      return with_radius(std::integral_constant<int, 1>{});
    case 2:
      return with_radius(std::integral_constant<int, 2>{});
    default:
      return with_radius(std::integral_constant<int, 3>{});
  }
}

/// Mean of the known variances, 0 where there is none.
template <class Executor>
float mean_variance_m2(Executor& executor, ImageView<const float> variance_m2) {
  const Size size = variance_m2.size();
  const std::int64_t count = executor.sum_pixels(size, WienerVarianceCount{variance_m2});
  if (count == 0) return 0;
  const std::int64_t sum = executor.sum_pixels(size, WienerVarianceSum{variance_m2});
  return static_cast<float>(static_cast<double>(sum) / static_cast<double>(count) /
                            WienerVarianceSum::units_per_m2);
}

/// Adaptive Wiener filter over valid pixels (paper eq. 2; Lim 1990, eqs 9.44-9.46). `mean_m` and
/// `variance_m2` are scratch of the same size. Missing pixels stay missing.
template <class Executor>
void wiener(Executor& executor, const WienerParams& params, const DepthNoise& sensor,
            ImageView<const float> depth_m, ImageView<float> mean_m, ImageView<float> variance_m2,
            ImageView<float> out) {
  const Size size = depth_m.size();
  with_window(params, [&](auto radius, auto detrend) {
    executor.for_each_pixel(size, WienerStatisticsOp<radius(), detrend()>{depth_m, mean_m, variance_m2});
  });
  const bool use_sensor = params.noise == WienerNoise::sensor;
  const float noise_m2 = use_sensor ? 0.0f : mean_variance_m2(executor, variance_m2);
  executor.for_each_pixel(
      size, WienerApplyOp{depth_m, mean_m, variance_m2, params.gain, use_sensor, sensor, noise_m2, out});
}

}  // namespace facet
