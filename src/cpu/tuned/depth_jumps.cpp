#include "cpu/tuned/depth_jumps.hpp"

#include <algorithm>
#include <array>

#include "core/clones.hpp"

namespace facet {
namespace {

constexpr int reach = DepthJumpOp::radius;
constexpr int piece = 64;  ///< pixels of a row that are looked at together

/// A row of depths [m] and of their inverses [1/m], infinite where depth is missing.
struct DepthRow {
  const float *z, *inverse;

  DepthReading at(int x) const { return {z[x], inverse[x]}; }
};
/// The rows from `reach` above to `reach` below.
using DepthRows = std::array<DepthRow, 2 * reach + 1>;

/// Whether a pixel can have a jump to a neighbour at all: the fall of inverse depth times the square of depth
/// is no more than the step in depth, and slopes are taken off it. Leaves room for the rounding of both.
bool may_jump(const DepthJump& jump, float z, float farthest) {
  const float by_noise = jump.noise_sigmas * jump.noise.sigma_m(z), by_ratio = jump.jump_ratio * z;
  const float least_m = by_noise > by_ratio ? by_noise : by_ratio;
  return farthest - z > 0.9999f * least_m - 1e-6f * z;
}

FACET_CPU_CLONES void invert(const float* depth_m, int width, float* inverse) {
  for (int x = 0; x < width; ++x) inverse[x] = 1 / depth_m[x];
}

/// Whether any of the pixels begin ... end - 1 of a row may have a jump.
FACET_CPU_CLONES bool may_jump(const float* above, const float* row, const float* below, int begin, int end,
                               const DepthJump& shared_test) {
  const DepthJump jump = shared_test;
  int any = 0;
  for (int x = begin; x < end; ++x) {
    const float beside = std::max(row[x - 1], row[x + 1]), across = std::max(above[x], below[x]);
    any |= may_jump(jump, row[x], std::max(beside, across)) ? 1 : 0;
  }
  return any != 0;
}

/// DepthJumpOp for the pixels begin ... end - 1 of a row.
FACET_CPU_CLONES void mark_jumps(const DepthRows& shared_rows, int begin, int end,
                                 const DepthJump& shared_test, std::uint8_t* edge) {
  const DepthJump is_jump = shared_test;  // local copies: what is written cannot alias them
  const DepthRows rows = shared_rows;
  const DepthRow row = rows[reach];
  int marked[piece];  // as wide as depths, so that they fill the same registers
#pragma GCC ivdep
  for (int x = begin; x < end; ++x) {
    const DepthReading here = row.at(x);
    const bool to_left = is_jump(here, row.at(x + 2), row.at(x - 1), row.at(x - 3));
    const bool to_right = is_jump(here, row.at(x - 2), row.at(x + 1), row.at(x + 3));
    const bool up = is_jump(here, rows[reach + 2].at(x), rows[reach - 1].at(x), rows[reach - 3].at(x));
    const bool down = is_jump(here, rows[reach - 2].at(x), rows[reach + 1].at(x), rows[reach + 3].at(x));
    marked[x - begin] = to_left | to_right | up | down;
  }
  for (int x = begin; x < end; ++x) edge[x] = static_cast<std::uint8_t>(marked[x - begin]);
}

}  // namespace

void depth_jumps(CpuExecutor& executor, const DepthEdgeParams& params, const DepthNoise& noise,
                 ImageView<const float> depth_m, ImageView<std::uint8_t> edge) {
  const DepthJumpOp op{depth_m, {params.jump_ratio, params.noise_sigmas, noise}, edge};
  const int width = depth_m.width, height = depth_m.height;
  std::vector<float>& inverses = executor.scratch().values;
  inverses.resize(static_cast<std::size_t>(depth_m.size().area()));
  const ImageView<float> inverse{inverses.data(), width, height, width};
  executor.for_each_row(height, [&](int y) { invert(depth_m.row(y), width, inverse.row(y)); });

  executor.for_each_row(height, [&](int y) {
    DepthRows rows;
    for (int j = 0; j <= 2 * reach; ++j) {
      const int nearest = std::clamp(y + j - reach, 0, height - 1);
      rows[static_cast<std::size_t>(j)] = {depth_m.row(nearest), inverse.row(nearest)};
    }
    const float *above = rows[reach - 1].z, *row = rows[reach].z, *below = rows[reach + 1].z;
    const auto mark_border = [&](int x) {
      const float beside = std::max(row[std::max(x - 1, 0)], row[std::min(x + 1, width - 1)]);
      if (may_jump(op.is_jump, row[x], std::max({beside, above[x], below[x]}))) op(x, y, GuardedAccess{});
    };
    std::fill_n(edge.row(y), width, std::uint8_t{0});
    const int begin = std::min(reach, width), end = std::max(begin, width - reach);
    for (int x = 0; x < begin; ++x) mark_border(x);
    for (int x = begin; x < end; x += piece) {
      const int piece_end = std::min(x + piece, end);
      if (may_jump(above, row, below, x, piece_end, op.is_jump))
        mark_jumps(rows, x, piece_end, op.is_jump, edge.row(y));
    }
    for (int x = end; x < width; ++x) mark_border(x);
  });
}

}  // namespace facet
