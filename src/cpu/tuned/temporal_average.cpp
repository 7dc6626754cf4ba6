#include "cpu/tuned/temporal_average.hpp"

#include "cpu/clones.hpp"

namespace facet {
namespace {

/// Readings that are missing sort behind all others.
constexpr float missing = 1e30f;

/// The readings of a piece of a row that stays in the first-level cache.
struct RowReadings {
  static constexpr int most = 256;
  int count = 0, width = 0;
  float z[max_temporal_frames][most];
};

FACET_CPU_CLONES void load(const float* from, int width, float* z) {
  for (int x = 0; x < width; ++x) z[x] = from[x] > 0 ? from[x] : missing;
}

FACET_CPU_CLONES void sort_pair(int width, float* __restrict a, float* __restrict b) {
  for (int x = 0; x < width; ++x) {
    const float low = a[x] < b[x] ? a[x] : b[x];
    b[x] = a[x] < b[x] ? b[x] : a[x];
    a[x] = low;
  }
}

/// Insertion sort of every pixel's readings at once.
void sort(RowReadings& readings) {
  for (int i = 1; i < readings.count; ++i)
    for (int k = i; k > 0; --k) sort_pair(readings.width, readings.z[k - 1], readings.z[k]);
}

/// Middle of the sorted readings that are there, 0 where none is, and how far from it a reading may lie.
FACET_CPU_CLONES void find_median(const RowReadings& readings, const DepthNoise& noise,
                                  float* __restrict median, float* __restrict tolerance) {
  int valid[RowReadings::most];
  for (int x = 0; x < readings.width; ++x) valid[x] = 0, median[x] = 0;
  for (int i = 0; i < readings.count; ++i)
    for (int x = 0; x < readings.width; ++x) valid[x] += readings.z[i][x] < missing ? 1 : 0;
  for (int i = 0; i < readings.count; ++i)
    for (int x = 0; x < readings.width; ++x)
      median[x] = valid[x] > 0 && valid[x] / 2 == i ? readings.z[i][x] : median[x];
  for (int x = 0; x < readings.width; ++x) tolerance[x] = 3 * noise.sigma_m(median[x]);
}

/// Mean of the readings that are there and within the tolerance of the centre, in their present order.
FACET_CPU_CLONES void mean_within(const RowReadings& readings, const float* __restrict centre,
                                  const float* __restrict tolerance, float* __restrict out) {
  float kept[RowReadings::most], sum[RowReadings::most];
  for (int x = 0; x < readings.width; ++x) kept[x] = sum[x] = 0;
  for (int i = 0; i < readings.count; ++i)
    for (int x = 0; x < readings.width; ++x) {
      const float z = readings.z[i][x], d = z - centre[x];
      const bool keep = (z < missing) & (d <= tolerance[x]) & (d >= -tolerance[x]);
      sum[x] += keep ? z : 0.0f;
      kept[x] += keep ? 1.0f : 0.0f;
    }
  for (int x = 0; x < readings.width; ++x) out[x] = kept[x] > 0 ? sum[x] / kept[x] : 0.0f;
}

}  // namespace

void temporal_average(CpuExecutor& executor, const TemporalParams& params, const DepthNoise& noise,
                      const TemporalHistory<CpuExecutor>& history, ImageView<float> out) {
  executor.for_each_row(out.height, [&](int y) {
    RowReadings readings;
    float centre[RowReadings::most], tolerance[RowReadings::most];
    readings.count = history.count();
    for (int begin = 0; begin < out.width; begin += RowReadings::most) {
      readings.width = std::min(RowReadings::most, out.width - begin);
      for (int i = 0; i < readings.count; ++i)
        load(history.frame(i).row(y) + begin, readings.width, readings.z[i]);
      if (params.mode == TemporalMode::robust) {
        sort(readings);
        find_median(readings, noise, centre, tolerance);
      } else {
        std::fill_n(centre, readings.width, 0.0f);
        std::fill_n(tolerance, readings.width, missing);
      }
      mean_within(readings, centre, tolerance, out.row(y) + begin);
    }
  });
}

}  // namespace facet
