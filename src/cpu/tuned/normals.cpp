#include "cpu/tuned/normals.hpp"

#include <algorithm>

#include "core/clones.hpp"

namespace facet {
namespace {

/// Window sums along a piece of a row that stays in the first-level cache. All are integers below 2^48.
struct Piece {
  static constexpr int most = 64;
  static constexpr int most_columns = most + 2 * 255;  ///< a window reaches no farther than a distance can
  int half[most];
  double column[most_columns], column_dy[most_columns];  ///< sums of q and dy q over columns of windows
  double sum[most], dx_sum[most], dy_sum[most];
};

/// Half sides of the windows of a piece; returns the largest.
FACET_CPU_CLONES int find_halves(const std::uint8_t* distance_px, int count, int radius_px, int* half) {
  int largest = 0;
  for (int i = 0; i < count; ++i) {
    half[i] = fit_half_side(distance_px[i], radius_px);
    largest = std::max(largest, half[i]);
  }
  return largest;
}

FACET_CPU_CLONES void sum_columns(ImageView<const std::int32_t> q, int begin, int end, int y, int half,
                                  Piece& piece) {
  const int count = end - begin;
  const std::int32_t* row = q.row(y) + begin;
  for (int x = 0; x < count; ++x) {
    piece.column[x] = row[x];
    piece.column_dy[x] = 0;
  }
  for (int k = 1; k <= half; ++k) {
    const std::int32_t *above = q.row(y - k) + begin, *below = q.row(y + k) + begin;
    for (int x = 0; x < count; ++x) {  // inverse depths are below 2^28: 32 bits hold the sum of two
      piece.column[x] += static_cast<double>(below[x] + above[x]);
      piece.column_dy[x] += k * static_cast<double>(below[x] - above[x]);
    }
  }
}

FACET_CPU_CLONES void sum_windows(int count, int half, Piece& piece) {
  const double *column = piece.column + half, *column_dy = piece.column_dy + half;
  for (int x = 0; x < count; ++x) {
    piece.sum[x] = column[x];
    piece.dx_sum[x] = 0;
    piece.dy_sum[x] = column_dy[x];
  }
  for (int k = 1; k <= half; ++k)
    for (int x = 0; x < count; ++x) {
      piece.sum[x] += column[x + k] + column[x - k];
      piece.dx_sum[x] += k * (column[x + k] - column[x - k]);
      piece.dy_sum[x] += column_dy[x + k] + column_dy[x - k];
    }
}

/// Normals of those of the pixels begin ... end - 1 that have this half side; `at` is the first of them in
/// the piece.
FACET_CPU_CLONES void fit_windows(const Piece& piece, int at, int begin, int end, int y, int half,
                                  const Camera& camera, const NormalViews<float>& normal) {
  float *nx = normal.x.row(y), *ny = normal.y.row(y), *nz = normal.z.row(y);
#pragma GCC ivdep
  for (int x = begin; x < end; ++x) {
    const int i = x - begin;
    const WindowSums sums{static_cast<float>(piece.sum[i]), static_cast<float>(piece.dx_sum[i]),
                          static_cast<float>(piece.dy_sum[i])};
    const Vec3 n = normal_from_sums(sums, half, x, y, camera);
    const bool fits = piece.half[at + i] == half;
    nx[x] = fits ? n.x : nx[x];
    ny[x] = fits ? n.y : ny[x];
    nz[x] = fits ? n.z : nz[x];
  }
}

}  // namespace

void fit_normals(CpuExecutor& executor, int radius_px, const Camera& camera,
                 ImageView<const std::int32_t> inverse_depth, ImageView<const std::uint8_t> distance_px,
                 const NormalViews<float>& normal) {
  const auto fit_piece = [&](int begin, int end, int y) {
    Piece piece;
    const int count = end - begin;
    const int largest = find_halves(distance_px.row(y) + begin, count, radius_px, piece.half);
    for (const ImageView<float>& part : {normal.x, normal.y, normal.z})
      std::fill_n(part.row(y) + begin, count, 0.0f);
    const int *halves = piece.half, *halves_end = halves + count;
    for (int half = 1; half <= largest; ++half) {
      const auto first = std::find(halves, halves_end, half);
      if (first == halves_end) continue;
      const auto last = std::find(std::reverse_iterator(halves_end), std::reverse_iterator(first), half);
      const int at = static_cast<int>(first - halves);
      const int from = begin + at, to = begin + static_cast<int>(last.base() - halves);
      sum_columns(inverse_depth, from - half, to + half, y, half, piece);
      sum_windows(to - from, half, piece);
      fit_windows(piece, at, from, to, y, half, camera, normal);
    }
  };
  executor.for_each_row(inverse_depth.height, [&](int y) {
    for (int begin = 0; begin < inverse_depth.width; begin += Piece::most)
      fit_piece(begin, std::min(begin + Piece::most, inverse_depth.width), y);
  });
}

}  // namespace facet
