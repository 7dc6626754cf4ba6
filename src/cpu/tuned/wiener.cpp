#include "cpu/tuned/wiener.hpp"

#include <algorithm>

#include "core/clones.hpp"

namespace facet {
namespace {

/// Columns of windows of a piece of a row, which stay in the first-level cache.
template <int radius>
struct Columns {
  static constexpr int most = 256;
  float sum[most + 2 * radius];
  int valid[most + 2 * radius];
};

template <int radius>
FACET_CPU_CLONES void sum_columns(ImageView<const float> depth_m, int begin, int end, int y,
                                  Columns<radius>& columns) {
  const float* above = depth_m.row(y - radius) + begin - radius;
  const int width = end - begin + 2 * radius;
  for (int x = 0; x < width; ++x) {
    float sum = 0;
    int valid = 0;
    FACET_UNROLL for (int j = 0; j <= 2 * radius; ++j) {
      const float z = above[j * depth_m.stride + x];
      valid += z > 0 ? 1 : 0;
      sum += z;
    }
    columns.sum[x] = sum;
    columns.valid[x] = valid;
  }
}

template <int radius, bool detrend>
FACET_CPU_CLONES void finish_windows(const WienerStatisticsOp<radius, detrend>& shared_op,
                                     const Columns<radius>& columns, int begin, int end, int y) {
  const WienerStatisticsOp<radius, detrend> op = shared_op;  // cannot alias what it writes
#pragma GCC ivdep
  for (int x = begin; x < end; ++x) {
    float sum = 0;
    int valid = 0;
    FACET_UNROLL for (int i = 0; i <= 2 * radius; ++i) {
      valid += columns.valid[x - begin + i];
      sum += columns.sum[x - begin + i];
    }
    op.finish(x, y, sum, valid, InteriorAccess{});
  }
}

}  // namespace

template <int radius, bool detrend>
void window_statistics(CpuExecutor& executor, const WienerStatisticsOp<radius, detrend>& op) {
  const Size size = op.depth_m.size();
  executor.for_each_row(size.height, [&](int y) {
    const bool inside = y >= radius && y < size.height - radius && size.width > 2 * radius;
    const int first = inside ? radius : size.width, last = inside ? size.width - radius : size.width;
    for (int x = 0; x < first; ++x) op(x, y, GuardedAccess{});
    Columns<radius> columns;
    for (int begin = first; begin < last; begin += Columns<radius>::most) {
      const int end = std::min(begin + Columns<radius>::most, last);
      sum_columns(op.depth_m, begin, end, y, columns);
      finish_windows(op, columns, begin, end, y);
    }
    for (int x = last; x < size.width; ++x) op(x, y, GuardedAccess{});
  });
}

template void window_statistics(CpuExecutor&, const WienerStatisticsOp<1, false>&);
template void window_statistics(CpuExecutor&, const WienerStatisticsOp<1, true>&);
template void window_statistics(CpuExecutor&, const WienerStatisticsOp<2, false>&);
template void window_statistics(CpuExecutor&, const WienerStatisticsOp<2, true>&);
template void window_statistics(CpuExecutor&, const WienerStatisticsOp<3, false>&);
template void window_statistics(CpuExecutor&, const WienerStatisticsOp<3, true>&);

}  // namespace facet
