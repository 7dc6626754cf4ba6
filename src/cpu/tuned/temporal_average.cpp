#include "cpu/tuned/temporal_average.hpp"

#include <array>
#include <cstring>

#include "core/clones.hpp"

namespace facet {
namespace {

/// Eight pixels side by side; comparisons give -1 where they hold.
using Float8 = float __attribute__((vector_size(32)));
using Int8 = int __attribute__((vector_size(32)));
constexpr int lanes = 8;
/// Longer windows take the plain operation: more readings than this do not fit the registers, and the code
/// for them is slow to compile.
constexpr int most_frames = 8;

/// Readings that are missing sort behind all others.
constexpr float missing = 1e30f;

/// The readings of a row, a pointer for each frame.
using Rows = std::array<const float*, most_frames>;

/// TemporalAverageOp for the eight pixels from x on. Unrolled for the number of frames, so that the readings
/// stay in registers.
template <int count, TemporalMode mode>
[[gnu::always_inline]] inline void average_eight(const Rows& rows, int x, const DepthNoise& noise,
                                                 float* out) {
  Float8 z[count];
  Int8 valid{};
#pragma GCC unroll 8
  for (int i = 0; i < count; ++i) {
    Float8 reading;
    std::memcpy(&reading, rows[static_cast<std::size_t>(i)] + x, sizeof reading);
    z[i] = reading > 0 ? reading : Float8{} + missing;
    valid -= reading > 0;
  }
  Float8 centre{}, tolerance = Float8{} + missing;
  if constexpr (mode == TemporalMode::robust) {
#pragma GCC unroll 8
    for (int i = 1; i < count; ++i)
#pragma GCC unroll 8
      for (int k = i; k > 0; --k) {
        const Float8 a = z[k - 1], b = z[k];
        z[k - 1] = a < b ? a : b;
        z[k] = a < b ? b : a;
      }
#pragma GCC unroll 8
    for (int i = 0; i < count; ++i) centre = ((valid > 0) & (valid >> 1 == i)) ? z[i] : centre;
    const Float8 beyond = centre - noise.z0_m;  // as DepthNoise::sigma_m
    tolerance = 3 * (noise.a_m + noise.b_per_m * beyond * beyond);
  }
  Float8 sum{};
  Int8 kept{};
#pragma GCC unroll 8
  for (int i = 0; i < count; ++i) {
    const Float8 d = z[i] - centre;
    const Int8 keep = (z[i] < missing) & (d <= tolerance) & (d >= -tolerance);
    sum += keep ? z[i] : Float8{};
    kept -= keep;
  }
  const Float8 mean = kept > 0 ? sum / __builtin_convertvector(kept, Float8) : Float8{};
  std::memcpy(out + x, &mean, sizeof mean);
}

template <int count, TemporalMode mode>
FACET_CPU_CLONES void average_row(const Rows& rows, int width, const DepthNoise& noise, float* out) {
  int x = 0;
  for (; x + lanes <= width; x += lanes) average_eight<count, mode>(rows, x, noise, out);
  if (x < width) average_eight<count, mode>(rows, width - lanes, noise, out);  // some a second time
}

template <int count = 1>
void average_row(const Rows& rows, int frames, int width, TemporalMode mode, const DepthNoise& noise,
                 float* out) {
  if (frames == count)
    return mode == TemporalMode::robust ? average_row<count, TemporalMode::robust>(rows, width, noise, out)
                                        : average_row<count, TemporalMode::mean>(rows, width, noise, out);
  if constexpr (count < most_frames) average_row<count + 1>(rows, frames, width, mode, noise, out);
}

}  // namespace

void temporal_average(CpuExecutor& executor, const TemporalParams& params, const DepthNoise& noise,
                      const TemporalHistory<CpuExecutor>& history, ImageView<float> out) {
  TemporalAverageOp op{history.count(), params.mode, noise, out, {}};
  for (int i = 0; i < history.count(); ++i) op.frames[i] = history.frame(i);
  if (out.width < lanes || op.count > most_frames) return executor.for_each_pixel(out.size(), op);
  executor.for_each_row(out.height, [&](int y) {
    Rows rows{};
    for (int i = 0; i < op.count; ++i) rows[static_cast<std::size_t>(i)] = op.frames[i].row(y);
    average_row(rows, op.count, out.width, params.mode, noise, out.row(y));
  });
}

}  // namespace facet
