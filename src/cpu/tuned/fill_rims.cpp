#include "cpu/tuned/fill_rims.hpp"

#include <array>
#include <utility>

#include "core/clones.hpp"
#include "core/run.hpp"

namespace facet {
namespace {

/// What lies before a row's pixels along lines from the rows passed already: the last depth [m], 0 = none,
/// and the number of missing pixels since.
struct Before {
  float *depth_m, *gap;
};

FACET_CPU_CLONES void mark_row(const float* depth_m, int width, const FillParams& params, Before from,
                               Before to, std::uint8_t* rim) {
  const float jump = params.rim_jump, gap_end = static_cast<float>(params.rim_search_px);
#pragma GCC ivdep
  for (int x = 0; x < width; ++x) {
    const float z = depth_m[x], before = from.depth_m[x], gap = from.gap[x];
    const bool measured = z > 0;
    const bool is_rim = measured & (gap > 0) & (gap < gap_end) & (before > z * (1 + jump));
    rim[x] |= is_rim ? 1 : 0;
    to.depth_m[x] = measured ? z : before;
    to.gap[x] = measured ? 0.0f : gap + 1;
  }
}

/// Marks what has a hole before it on the way through the rows from `first` in steps of `step`, in the three
/// directions that lead from row to row.
void mark_along(std::vector<float>& memory, const FillParams& params, ImageView<const float> depth_m,
                int first, int step, ImageView<std::uint8_t> rim) {
  const std::size_t pitch = static_cast<std::size_t>(depth_m.width) + 2;  // nothing beyond the image
  memory.assign(12 * pitch, 0);
  std::array<Before, 3> from, to;
  float* at = memory.data() + 1;
  for (auto* lines : {&from, &to})
    for (Before& line : *lines) line = {at, at + pitch}, at += 2 * pitch;
  for (int i = 0, y = first; i < depth_m.height; ++i, y += step) {
    for (int dx = -1; dx <= 1; ++dx) {
      const Before &before = from[static_cast<std::size_t>(dx + 1)],
                   &here = to[static_cast<std::size_t>(dx + 1)];
      mark_row(depth_m.row(y), depth_m.width, params, {before.depth_m + dx, before.gap + dx}, here,
               rim.row(y));
    }
    std::swap(from, to);
  }
}

/// Marks the ends of the holes of a row.
void mark_ends(const float* depth_m, const std::uint8_t* missing, int width, const FillParams& params,
               std::uint8_t* rim) {
  for (int end = 0; end < width;) {
    const int begin = end_of_run<std::uint8_t>(missing, end, width, 0);
    end = end_of_run<std::uint8_t>(missing, begin, width, 1);
    if (begin == 0 || end == width || end - begin >= params.rim_search_px) continue;
    const float left = depth_m[begin - 1], right = depth_m[end];
    if (right > left * (1 + params.rim_jump)) rim[begin - 1] = 1;
    if (left > right * (1 + params.rim_jump)) rim[end] = 1;
  }
}

}  // namespace

void mark_rims(CpuScratch& scratch, const FillParams& params, ImageView<const float> depth_m,
               ImageView<const std::uint8_t> missing, ImageView<std::uint8_t> rim) {
  for (int y = 0; y < depth_m.height; ++y)
    mark_ends(depth_m.row(y), missing.row(y), depth_m.width, params, rim.row(y));
  mark_along(scratch.values, params, depth_m, 0, 1, rim);
  mark_along(scratch.values, params, depth_m, depth_m.height - 1, -1, rim);
}

}  // namespace facet
