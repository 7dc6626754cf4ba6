#include "cpu/tuned/wiener.hpp"

#include <algorithm>
#include <atomic>

#include "core/clones.hpp"
#include "cpu/padded_rows.hpp"

namespace facet {
namespace {

/// What is known about the windows of a piece of a row. It is worked out in steps that are short enough for
/// the processor to have several of them in flight.
template <int radius>
struct Windows {
  static constexpr int pitch = PaddedRows<radius>::pitch;
  float column_sum[pitch];  ///< [0] is `radius` pixels before the piece
  int column_valid[pitch];
  float count[pitch], mean_m[pitch], squares_m2[pitch], variance_m2[pitch];
};

template <int radius>
FACET_CPU_CLONES void sum_columns(RowsAround<radius> rows, int count, Windows<radius>& windows) {
#pragma GCC ivdep
  for (int x = 0; x < count + 2 * radius; ++x) {
    float sum = 0;
    int valid = 0;
    FACET_UNROLL for (std::size_t j = 0; j < rows.size(); ++j) {
      const float z = rows[j][x - radius];
      valid += z > 0 ? 1 : 0;
      sum += z;
    }
    windows.column_sum[x] = sum;
    windows.column_valid[x] = valid;
  }
}

template <int radius>
FACET_CPU_CLONES void find_means(int count, Windows<radius>& windows) {
#pragma GCC ivdep
  for (int x = 0; x < count; ++x) {
    float sum = 0;
    int valid = 0;
    FACET_UNROLL for (int i = 0; i <= 2 * radius; ++i) {
      sum += windows.column_sum[x + i];
      valid += windows.column_valid[x + i];
    }
    const float n = static_cast<float>(valid > 0 ? valid : 1);
    windows.count[x] = n;
    windows.mean_m[x] = sum / n;
  }
}

/// Sum of the squared differences from the mean, less what the slope explains.
template <int radius, bool detrend>
FACET_CPU_CLONES void sum_squares(RowsAround<radius> image, int count, Windows<radius>& windows) {
  constexpr int side = 2 * radius + 1;
  constexpr float spread = side * side * radius * (radius + 1) / 3.0f;
#pragma GCC ivdep
  for (int x = 0; x < count; ++x) {
    const float mean = windows.mean_m[x];
    float squares = 0, rows[side] = {}, columns[side] = {};
    FACET_UNROLL for (int j = 0; j < side; ++j) {
      float row_squares = 0;
      FACET_UNROLL for (int i = 0; i < side; ++i) {
        const float z = image[static_cast<std::size_t>(j)][x + i - radius];
        const float d = z > 0 ? z - mean : 0.0f;
        row_squares += d * d;
        rows[j] += d;
        columns[i] += d;
      }
      squares += row_squares;
    }
    float along_x = 0, along_y = 0;
    FACET_UNROLL for (int k = 1; k <= radius; ++k) {
      along_x += static_cast<float>(k) * (columns[radius + k] - columns[radius - k]);
      along_y += static_cast<float>(k) * (rows[radius + k] - rows[radius - k]);
    }
    const float explained = (along_x * along_x + along_y * along_y) / spread;
    windows.squares_m2[x] = detrend ? squares - explained : squares;
  }
}

template <int radius>
FACET_CPU_CLONES void find_variances(const float* depth_m, int count, Windows<radius>& windows) {
  constexpr float least = WienerStatisticsOp<radius, true>::min_valid;
#pragma GCC ivdep
  for (int x = 0; x < count; ++x) {
    const float n = windows.count[x], squares = windows.squares_m2[x];
    const float variance = (squares > 0 ? squares : 0.0f) / n;
    const bool usable = (depth_m[x] > 0) & (n >= least);
    windows.variance_m2[x] = usable ? variance : -1.0f;
  }
}

/// Number and sum of the known variances, as integers: exact in any order.
struct VarianceSum {
  std::int64_t count = 0, sum = 0;
};
template <int radius>
FACET_CPU_CLONES VarianceSum sum_variances(const Windows<radius>& windows, int count) {
  const ImageView<const float> variance_m2{windows.variance_m2, count, 1, 0};
  const WienerVarianceCount is_known{variance_m2};
  const WienerVarianceSum in_units{variance_m2};
  VarianceSum total;
  for (int x = 0; x < count; ++x) total.count += is_known(x, 0), total.sum += in_units(x, 0);
  return total;
}

/// Filters a piece of a row whose statistics are known.
template <int radius>
FACET_CPU_CLONES void apply(const WienerApplyOp& shared_op, const float* depth_m,
                            const Windows<radius>& windows, int count, float* out_m) {
  WienerApplyOp op = shared_op;
  op.depth_m = {depth_m, count, 1, 0};
  op.mean_m = {windows.mean_m, count, 1, 0};
  op.variance_m2 = {windows.variance_m2, count, 1, 0};
  op.out = {out_m, count, 1, 0};
#pragma GCC ivdep
  for (int x = 0; x < count; ++x) op(x, 0, InteriorAccess{});
}

/// done(begin, end, y, windows) for every piece of every row, when its statistics are known.
template <int radius, bool detrend, class Done>
void measure_windows(CpuExecutor& executor, ImageView<const float> depth_m, const Done& done) {
  constexpr int most = PaddedRows<radius>::most;
  executor.for_each_band(depth_m.height, [&](int first, int last) {
    Windows<radius> windows;
    for (int begin = 0; begin < depth_m.width; begin += most) {
      const int end = std::min(begin + most, depth_m.width), count = end - begin;
      PaddedRows<radius> image(depth_m, begin, end);
      for (int y = first; y < last; ++y) {
        const RowsAround<radius> rows = image.around(y);
        sum_columns<radius>(rows, count, windows);
        find_means(count, windows);
        sum_squares<radius, detrend>(rows, count, windows);
        find_variances(rows[radius], count, windows);
        done(begin, end, y, windows);
      }
    }
  });
}

template <int radius, bool detrend>
void filter(CpuExecutor& executor, WienerApplyOp apply_op, ImageView<float> mean_m,
            ImageView<float> variance_m2) {
  const ImageView<const float> depth_m = apply_op.depth_m;
  const ImageView<float> out = apply_op.out;
  if (apply_op.use_sensor)
    return measure_windows<radius, detrend>(
        executor, depth_m, [&](int begin, int end, int y, const Windows<radius>& windows) {
          apply(apply_op, depth_m.row(y) + begin, windows, end - begin, out.row(y) + begin);
        });
  std::atomic<std::int64_t> count = 0, sum = 0;
  measure_windows<radius, detrend>(
      executor, depth_m, [&](int begin, int end, int y, const Windows<radius>& windows) {
        std::copy_n(windows.mean_m, end - begin, mean_m.row(y) + begin);
        std::copy_n(windows.variance_m2, end - begin, variance_m2.row(y) + begin);
        const VarianceSum total = sum_variances(windows, end - begin);
        count += total.count, sum += total.sum;
      });
  if (count > 0)  // as mean_variance_m2
    apply_op.noise_m2 = static_cast<float>(static_cast<double>(sum) / static_cast<double>(count) /
                                           WienerVarianceSum::units_per_m2);
  executor.for_each_pixel(depth_m.size(), apply_op);
}

}  // namespace

void wiener(CpuExecutor& executor, const WienerParams& params, const DepthNoise& sensor,
            ImageView<const float> depth_m, ImageView<float> mean_m, ImageView<float> variance_m2,
            ImageView<float> out) {
  const bool use_sensor = params.noise == WienerNoise::sensor;
  const WienerApplyOp op{depth_m, mean_m, variance_m2, params.gain, use_sensor, sensor, 0, out};
  with_window(params, [&](auto radius, auto detrend) {
    filter<radius(), detrend()>(executor, op, mean_m, variance_m2);
  });
}

}  // namespace facet
