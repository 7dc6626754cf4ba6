#include "cpu/tuned/basins.hpp"

#include <algorithm>
#include <atomic>

#include "core/clones.hpp"

namespace facet {
namespace {

/// Heights in raster order, between two rows of barriers and with one behind every row.
struct HeightMap {
  float* first;
  int stride;

  float* row(int y) const { return first + static_cast<std::ptrdiff_t>(y + 1) * stride; }
};

FACET_CPU_CLONES void measure_row(const CreaseHeight& height, int width, int y, float* row) {
  const float* strength = height.strength.row(y);
  const std::uint8_t* distance = height.distance_px.row(y);
  const int guard_px = height.guard_px;
  const float floor = height.floor;
  for (int x = 0; x < width; ++x) {
    const int missing_px = guard_px - distance[x];
    const float known = strength[x] > floor ? strength[x] : 0.0f;
    const float h = missing_px >= 0 ? CreaseHeight::unknown + static_cast<float>(missing_px) : known;
    row[x] = distance[x] == 0 ? CreaseHeight::barrier : h;
  }
}

/// DescendOp for a row. Of equal heights the earlier pixel is lower, so candidates come in raster order.
FACET_CPU_CLONES void descend_row(const HeightMap& map, int width, int y, std::int32_t* next) {
  const float *here = map.row(y), *above = here - map.stride, *below = here + map.stride;
  const int begin = y * width;
#pragma GCC ivdep
  for (int x = 0; x < width; ++x) {
    const int own = begin + x;
    float lowest = above[x];
    int target = own - width;
    target = here[x - 1] < lowest ? own - 1 : target, lowest = std::min(lowest, here[x - 1]);
    target = here[x] < lowest ? own : target, lowest = std::min(lowest, here[x]);
    target = here[x + 1] < lowest ? own + 1 : target, lowest = std::min(lowest, here[x + 1]);
    target = below[x] < lowest ? own + width : target;
    const bool descends = (here[x] > 0) & (here[x] < CreaseHeight::barrier);
    next[x] = descends ? target : next[x];
  }
}

/// Where the pointers from a pixel end, -1 = on a barrier. Leaves what it passes nearer to that; threads may
/// see each other's doing, which leads to the same basin.
inline int basin_of(std::vector<int>& next, int pixel) {
  const auto at = [&next](int i) { return std::atomic_ref<int>(next[static_cast<std::size_t>(i)]); };
  int i = pixel, to = at(i).load(std::memory_order_relaxed);
  if (to < 0) return -1;
  while (to != i) {
    to = at(to).load(std::memory_order_relaxed);
    at(i).store(to, std::memory_order_relaxed);
    i = to, to = at(i).load(std::memory_order_relaxed);
  }
  return i;
}

}  // namespace

void crease_basins(CpuExecutor& executor, const CreaseHeight& height, ImageView<std::int32_t> root) {
  const int width = root.width, stride = width + 1;
  std::vector<float>& values = executor.scratch().values;
  values.resize(static_cast<std::size_t>(root.height + 2) * static_cast<std::size_t>(stride) + 1);
  const HeightMap map{values.data() + 1, stride};
  std::fill_n(map.row(-1) - 1, stride + 1, CreaseHeight::barrier);
  std::fill_n(map.row(root.height), width, CreaseHeight::barrier);
  executor.for_each_row(root.height, [&](int y) {
    measure_row(height, width, y, map.row(y));
    map.row(y)[width] = CreaseHeight::barrier;
  });
  std::vector<int>& next = executor.scratch().list_a;
  next.resize(static_cast<std::size_t>(root.size().area()));
  executor.for_each_row(root.height, [&](int y) {
    int* row = next.data() + static_cast<std::ptrdiff_t>(y) * width;
    std::copy_n(root.row(y), width, row);
    descend_row(map, width, y, row);
  });
  executor.for_each_row(root.height, [&](int y) {
    for (int x = 0; x < width; ++x) root(x, y) = basin_of(next, y * width + x);
  });
}

}  // namespace facet
