#include "cpu/tuned/depth_jumps.hpp"

#include <algorithm>

#include "core/clones.hpp"

namespace facet {
namespace {

/// A row of depths [m] and of their inverses [1/m], infinite where depth is missing.
struct DepthRow {
  const float *z, *inverse;

  DepthReading at(int x) const { return {z[x], inverse[x]}; }
  DepthRow shifted(int dx) const { return {z + dx, inverse + dx}; }
};

/// The samples of a row's pixels in one direction: two pixels before, one and three pixels after.
struct Samples {
  DepthRow before, far, beyond;
};

FACET_CPU_CLONES void invert(const float* depth_m, int width, float* inverse) {
  for (int x = 0; x < width; ++x) inverse[x] = 1 / depth_m[x];
}

/// DepthJumpOp in one direction, for the pixels begin ... end - 1 of a row.
FACET_CPU_CLONES void mark_jumps(const DepthRow& shared_row, const Samples& shared_samples, int begin,
                                 int end, const DepthJump& shared_test, std::uint8_t* edge) {
  const DepthJump is_jump = shared_test;  // local copies: what is written cannot alias them
  const DepthRow row = shared_row;
  const Samples samples = shared_samples;
#pragma GCC ivdep
  for (int x = begin; x < end; ++x) {
    const bool jump = is_jump(row.at(x), samples.before.at(x), samples.far.at(x), samples.beyond.at(x));
    edge[x] |= jump ? 1 : 0;
  }
}

}  // namespace

void depth_jumps(CpuExecutor& executor, const DepthEdgeParams& params, const DepthNoise& noise,
                 ImageView<const float> depth_m, ImageView<std::uint8_t> edge) {
  constexpr int reach = DepthJumpOp::radius;
  const DepthJumpOp op{depth_m, {params.jump_ratio, params.noise_sigmas, noise}, edge};
  const int width = depth_m.width, height = depth_m.height;
  std::vector<float>& inverses = executor.scratch().values;
  inverses.resize(static_cast<std::size_t>(depth_m.size().area()));
  const ImageView<float> inverse{inverses.data(), width, height, width};
  executor.for_each_row(height, [&](int y) { invert(depth_m.row(y), width, inverse.row(y)); });

  const auto row_at = [&](int y) -> DepthRow {
    const int nearest = std::clamp(y, 0, height - 1);
    return {depth_m.row(nearest), inverse.row(nearest)};
  };
  executor.for_each_row(height, [&](int y) {
    const int begin = std::min(reach, width), end = std::max(begin, width - reach);
    std::fill_n(edge.row(y), width, std::uint8_t{0});
    const DepthRow row = row_at(y);
    for (const int side : {-1, 1}) {
      mark_jumps(row, {row.shifted(-2 * side), row.shifted(side), row.shifted(3 * side)}, begin, end,
                 op.is_jump, edge.row(y));
      mark_jumps(row, {row_at(y - 2 * side), row_at(y + side), row_at(y + 3 * side)}, begin, end, op.is_jump,
                 edge.row(y));
    }
    for (int x = 0; x < begin; ++x) op(x, y, GuardedAccess{});
    for (int x = end; x < width; ++x) op(x, y, GuardedAccess{});
  });
}

}  // namespace facet
