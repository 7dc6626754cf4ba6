#include "cpu/tuned/temporal_average.hpp"

#include <array>

#include "core/clones.hpp"

namespace facet {
namespace {

/// Longer windows take the plain operation: more readings than this do not fit the registers, and the code
/// for them is slow to compile.
constexpr int most_frames = 8;

/// Readings that are missing sort behind all others and lie within no tolerance.
constexpr float missing = 1e30f;

/// The readings of a row, a pointer for each frame.
using Rows = std::array<const float*, most_frames>;

/// TemporalAverageOp for a row. Unrolled for the number of frames, so that the readings stay in registers.
template <int count, TemporalMode mode>
FACET_CPU_CLONES void average_row(const Rows& shared_rows, int width, const DepthNoise& shared_noise,
                                  float* out) {
  const Rows rows = shared_rows;
  const DepthNoise noise = shared_noise;
#pragma GCC ivdep
  for (int x = 0; x < width; ++x) {
    float z[count], valid = 0;
    FACET_UNROLL for (int i = 0; i < count; ++i) {
      const float reading = rows[static_cast<std::size_t>(i)][x];
      z[i] = reading > 0 ? reading : missing;
      valid += reading > 0 ? 1.0f : 0.0f;
    }
    float centre = 0, tolerance = missing / 2;
    if constexpr (mode == TemporalMode::robust) {
      FACET_UNROLL for (int i = 1; i < count; ++i) FACET_UNROLL for (int k = i; k > 0; --k) {
        const float a = z[k - 1], b = z[k];
        z[k - 1] = a < b ? a : b;
        z[k] = a < b ? b : a;
      }
      FACET_UNROLL for (int i = 0; i < count; ++i) centre =
          valid >= static_cast<float>(2 * i) ? z[i] : centre;
      tolerance = 3 * noise.sigma_m(centre);
    }
    float sum = 0, kept = 0;
    FACET_UNROLL for (int i = 0; i < count; ++i) {
      const float d = z[i] - centre, distance = d < 0 ? -d : d;
      sum += distance <= tolerance ? z[i] : 0.0f;
      kept += distance <= tolerance ? 1.0f : 0.0f;
    }
    const float mean = sum / kept;
    out[x] = valid > 0 ? mean : 0.0f;
  }
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
  if (op.count > most_frames) return executor.for_each_pixel(out.size(), op);
  executor.for_each_row(out.height, [&](int y) {
    Rows rows{};
    for (int i = 0; i < op.count; ++i) rows[static_cast<std::size_t>(i)] = op.frames[i].row(y);
    average_row(rows, op.count, out.width, params.mode, noise, out.row(y));
  });
}

}  // namespace facet
