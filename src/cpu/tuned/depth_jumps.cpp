#include "cpu/tuned/depth_jumps.hpp"

#include <algorithm>

#include "cpu/clones.hpp"

namespace facet {
namespace {

/// A row of depths [m] and of their inverses [1/m], infinite where depth is missing.
struct DepthRow {
  const float *z, *inverse;

  DepthRow shifted(int dx) const { return {z + dx, inverse + dx}; }
};

/// The samples of a row's pixels in one direction: two pixels before, one and three pixels after.
struct Samples {
  DepthRow before, far, beyond;
};

FACET_CPU_CLONES void invert(const float* depth_m, int width, float* inverse) {
  for (int x = 0; x < width; ++x) inverse[x] = 1 / depth_m[x];
}

/// DepthJumpOp::slope without branches.
inline float slope(float from_m, float from_inverse, float to_m, float to_inverse, float jump_m) {
  const bool known = (from_m > 0) & (to_m > from_m) & !(to_m - from_m > 2 * jump_m);
  return known ? 0.5f * (from_inverse - to_inverse) : 0.0f;
}

/// DepthJumpOp in one direction, for the pixels begin ... end - 1 of a row.
FACET_CPU_CLONES void mark_jumps(const DepthRow& row, const Samples& samples, int begin, int end,
                                 const DepthEdgeParams& params, const DepthNoise& shared_noise,
                                 std::uint8_t* edge) {
  const auto [z, inverse] = row;
  const auto [before, far, beyond] = samples;
  const float jump_ratio = params.jump_ratio, noise_sigmas = params.noise_sigmas;
  const DepthNoise noise = shared_noise;
#pragma GCC ivdep
  for (int x = begin; x < end; ++x) {
    const float by_noise = noise_sigmas * noise.sigma_m(z[x]);
    const float by_ratio = jump_ratio * z[x];
    const float least_m = by_noise > by_ratio ? by_noise : by_ratio;
    const float step = inverse[x] - far.inverse[x];
    const float near_slope = slope(before.z[x], before.inverse[x], z[x], inverse[x], by_ratio);
    const float far_slope = slope(far.z[x], far.inverse[x], beyond.z[x], beyond.inverse[x], by_ratio);
    const float slope_max = near_slope > far_slope ? near_slope : far_slope;
    const bool jump = (z[x] > 0) & (far.z[x] > z[x]) & ((step - slope_max) * z[x] * z[x] > least_m);
    edge[x] |= jump ? 1 : 0;
  }
}

}  // namespace

void depth_jumps(CpuExecutor& executor, const DepthEdgeParams& params, const DepthNoise& noise,
                 ImageView<const float> depth_m, ImageView<std::uint8_t> edge) {
  constexpr int reach = DepthJumpOp::radius;
  const DepthJumpOp op{depth_m, params.jump_ratio, params.noise_sigmas, noise, edge};
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
      mark_jumps(row, {row.shifted(-2 * side), row.shifted(side), row.shifted(3 * side)}, begin, end, params,
                 noise, edge.row(y));
      mark_jumps(row, {row_at(y - 2 * side), row_at(y + side), row_at(y + 3 * side)}, begin, end, params,
                 noise, edge.row(y));
    }
    for (int x = 0; x < begin; ++x) op(x, y, GuardedAccess{});
    for (int x = end; x < width; ++x) op(x, y, GuardedAccess{});
  });
}

}  // namespace facet
