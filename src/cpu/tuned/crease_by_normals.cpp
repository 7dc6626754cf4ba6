#include "cpu/tuned/crease_by_normals.hpp"

#include <algorithm>
#include <array>

#include "core/clones.hpp"
#include "cpu/tuned/normal_rows.hpp"

namespace facet {
namespace {

/// Where the normals on one side of a row's pixels begin.
struct NormalRow {
  const float *x, *y, *z;
};
/// Both sides in the four directions.
struct Sides {
  std::array<NormalRow, 4> before, after;
};

Sides sides_of(const NormalChangeOp& op, int y) {
  const auto row_at = [&](Offset d, int steps) -> NormalRow {
    const int px = steps * d.dx, py = y + steps * d.dy;
    return {op.normal.x.row(py) + px, op.normal.y.row(py) + px, op.normal.z.row(py) + px};
  };
  Sides sides;
  for (int i = 0; i < 4; ++i) {
    const Offset d = direction4(i);
    const int steps = d.dx != 0 && d.dy != 0 ? (op.radius * 3 + 2) / 4 : op.radius;
    sides.before[static_cast<std::size_t>(i)] = row_at(d, -steps);
    sides.after[static_cast<std::size_t>(i)] = row_at(d, steps);
  }
  return sides;
}

/// Largest squared chord, and its direction, of `count` pixels from x on. A missing normal is not a number,
/// and so is a chord to it: no other is smaller.
FACET_CPU_CLONES void find_largest_chords(const Sides& shared_sides, int x, int count, float* chord,
                                          int* across) {
  const Sides sides = shared_sides;
#pragma GCC ivdep
  for (int i = x; i < x + count; ++i) {
    float best = 0;
    int best_direction = 0;
    FACET_UNROLL for (int k = 0; k < 4; ++k) {
      const NormalRow &from = sides.before[static_cast<std::size_t>(k)],
                      &to = sides.after[static_cast<std::size_t>(k)];
      const Vec3 d = Vec3{from.x[i], from.y[i], from.z[i]} - Vec3{to.x[i], to.y[i], to.z[i]};
      const float squared = dot(d, d);
      best_direction = squared > best ? k : best_direction;
      best = squared > best ? squared : best;
    }
    chord[i - x] = best;
    across[i - x] = best_direction;
  }
}

FACET_CPU_CLONES void guard(const float* chord, const int* across, const std::uint8_t* distance_px,
                            int guard_px, int count, float* strength, std::uint8_t* direction) {
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const bool guarded = distance_px[i] <= guard_px;
    strength[i] = sqrtf(guarded ? 0.0f : chord[i]);
    direction[i] = static_cast<std::uint8_t>(guarded ? 0 : across[i]);
  }
}

/// NormalChangeOp for a row.
void find_strengths(const NormalChangeOp& op, int y) {
  constexpr int most = 512;
  const int width = op.strength.width, height = op.strength.height;
  const auto visit_border = [&](int begin, int end) {
    for (int x = begin; x < end; ++x)
      if (op.distance_px(x, y) <= op.guard_px)
        op.strength(x, y) = 0, op.direction(x, y) = 0;
      else
        op(x, y, GuardedAccess{});
  };
  const bool inside = y >= op.radius && y < height - op.radius;
  if (!inside) return visit_border(0, width);
  const int first = op.radius, behind = width - op.radius;
  visit_border(0, first);
  const Sides sides = sides_of(op, y);
  float chord[most];
  int across[most];
  for (int x = first; x < behind; x += most) {
    const int count = std::min(most, behind - x);
    find_largest_chords(sides, x, count, chord, across);
    guard(chord, across, op.distance_px.row(y) + x, op.guard_px, count, op.strength.row(y) + x,
          op.direction.row(y) + x);
  }
  visit_border(behind, width);
}

}  // namespace

void crease_by_normals(CpuExecutor& executor, const CreaseParams& params, const Camera& camera,
                       ImageView<const std::int32_t> inverse_depth, ImageView<const std::uint8_t> distance_px,
                       const NormalViews<float>& scratch, ImageView<float> strength,
                       ImageView<std::uint8_t> direction) {
  const int radius = params.radius_px, width = strength.width, height = strength.height;
  if (width < NormalRows::least_width)
    return crease_by_normals<CpuExecutor>(executor, params, camera, inverse_depth, distance_px, scratch,
                                          strength, direction);
  std::vector<int>& largest = executor.scratch().list_a;
  find_largest(executor, inverse_depth, largest);
  const NormalRows normals{radius, camera, inverse_depth, distance_px, scratch, largest.data()};
  const NormalChangeOp change{scratch, distance_px, radius, params.depth_guard_px, strength, direction};
  executor.for_each_band(height, [&](int first, int behind) {
    for (int y = first; y < behind; ++y) {
      normals.fit(y);
      if (y - radius >= first + radius) find_strengths(change, y - radius);
    }
  });
  executor.for_each_band(height, [&](int first, int behind) {  // rows that need normals of another band
    const int second = std::min(first + radius, behind);
    for (int y = first; y < second; ++y) find_strengths(change, y);
    for (int y = std::max(behind - radius, second); y < behind; ++y) find_strengths(change, y);
  });
}

}  // namespace facet
