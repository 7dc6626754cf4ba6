#include "cpu/tuned/normal_rows.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "core/clones.hpp"
#include "cpu/lanes.hpp"
#include "stage/normals.hpp"

namespace facet {
namespace {

/// Sixteen sums each: 32 bits where they hold the largest, doubles, which hold integers below 2^53,
/// elsewhere.
using Doubles = double __attribute__((vector_size(128)));
struct NarrowSums {
  using Number = int;
  using Numbers = Ints;
};
struct WideSums {
  using Number = double;
  using Numbers = Doubles;
};

constexpr int reach = NormalRows::most_radius_px;

constexpr int most = 640;  ///< pixels of a piece
constexpr int margin = lanes + reach;
constexpr int pitch = most + 2 * margin;

/// Sums over windows beside each other.
struct WindowRow {
  float sum[pitch], dx_sum[pitch], dy_sum[pitch];
};

/// A piece of a row, in the first-level cache; there is room for groups of lanes that stand over its ends.
struct Piece {
  int begin, count;
  int half[pitch];
  unsigned present[most / lanes];  ///< for each group of lanes: bit h is set where h is among the half sides
  WindowRow sums;
};

template <class Sums>
struct Columns {
  typename Sums::Number sum[most + 2 * reach], dy_sum[most + 2 * reach];
};

FACET_CPU_CLONES void find_halves(const std::uint8_t* distance_px, int radius_px, int count, int* halves) {
  for (int i = 0; i < count; ++i) halves[i] = fit_half_side(distance_px[i], radius_px);
}

/// The half sides of a piece's windows; bit h of what is returned is set where h is among them. Most groups
/// have full windows alone.
unsigned find_halves(const std::uint8_t* distance_px, int radius_px, Piece& piece) {
  int* halves = piece.half + margin;
  std::fill_n(piece.half, margin, -1);
  std::fill_n(halves + piece.count, margin, -1);
  distance_px += piece.begin;
  find_halves(distance_px, radius_px, piece.count, halves);
  std::uint8_t full[lanes];
  std::fill_n(full, lanes, static_cast<std::uint8_t>(radius_px + 1));
  unsigned present = 0;
  for (int group = 0; group * lanes < piece.count; ++group) {
    const int begin = group * lanes, end = std::min(begin + lanes, piece.count);
    unsigned& here = piece.present[group];
    here = 0;
    if (end - begin == lanes && std::memcmp(distance_px + begin, full, sizeof full) == 0)
      here = 1u << radius_px;
    else
      for (int i = begin; i < end; ++i) here |= 1u << halves[i];
    present |= here;
  }
  return present;
}

/// Sums of q and of dy q over columns of windows, from the column x on.
template <class Sums>
FACET_CPU_CLONES void sum_columns(ImageView<const std::int32_t> q, int x, int y, int count, int half,
                                  Columns<Sums>& columns) {
  using Numbers = typename Sums::Numbers;
  for (int i = 0, last = count - lanes;; i = std::min(i + lanes, last)) {
    Ints row;
    load(q.row(y) + x + i, row);
    Numbers sum = __builtin_convertvector(row, Numbers), beyond{}, dy_sum{};
    for (int k = half; k > 0; --k) {  // k times the difference at k: it is added in k rounds
      Ints above, below;
      load(q.row(y - k) + x + i, above);
      load(q.row(y + k) + x + i, below);
      sum += __builtin_convertvector(below + above, Numbers);
      beyond += __builtin_convertvector(below - above, Numbers);
      dy_sum += beyond;
    }
    store(sum, columns.sum + i);
    store(dy_sum, columns.dy_sum + i);
    if (i == last) break;
  }
}

/// Sums over windows of that half side, the first of them around the column `half`.
template <class Sums>
FACET_CPU_CLONES void sum_windows(const Columns<Sums>& columns, int count, int half, WindowRow& windows) {
  using Numbers = typename Sums::Numbers;
  for (int i = 0, last = count - lanes;; i = std::min(i + lanes, last)) {
    const auto *column = columns.sum + i + half, *column_dy = columns.dy_sum + i + half;
    Numbers sum, dy_sum, beyond{}, dx_sum{};
    load(column, sum);
    load(column_dy, dy_sum);
    for (int k = half; k > 0; --k) {
      Numbers left, right, left_dy, right_dy;
      load(column - k, left);
      load(column + k, right);
      load(column_dy - k, left_dy);
      load(column_dy + k, right_dy);
      sum += right + left;
      dy_sum += right_dy + left_dy;
      beyond += right - left;
      dx_sum += beyond;
    }
    store(__builtin_convertvector(sum, Floats), windows.sum + i);
    store(__builtin_convertvector(dx_sum, Floats), windows.dx_sum + i);
    store(__builtin_convertvector(dy_sum, Floats), windows.dy_sum + i);
    if (i == last) break;
  }
}

/// Keeps the sums where the piece's windows, from `at` on, have that size.
FACET_CPU_CLONES void keep_sums(const WindowRow& windows, int count, int half, int at, Piece& piece) {
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const bool kept = piece.half[at + i] == half;
    piece.sums.sum[at + i] = kept ? windows.sum[i] : piece.sums.sum[at + i];
    piece.sums.dx_sum[at + i] = kept ? windows.dx_sum[i] : piece.sums.dx_sum[at + i];
    piece.sums.dy_sum[at + i] = kept ? windows.dy_sum[i] : piece.sums.dy_sum[at + i];
  }
}

FACET_CPU_CLONES void find_normals(const Piece& piece, int y, const Camera& shared_camera, float* nx,
                                   float* ny, float* nz) {
  const Camera camera = shared_camera;
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
#pragma GCC ivdep
  for (int i = 0; i < piece.count; ++i) {
    const int at = margin + i;
    const WindowSums sums{piece.sums.sum[at], piece.sums.dx_sum[at], piece.sums.dy_sum[at]};
    const Vec3 n = normal_from_sums(sums, piece.half[at], piece.begin + i, y, camera);
    nx[i] = n.x;
    ny[i] = n.y;
    nz[i] = n.z;
  }
  for (int i = 0; i < piece.count; ++i) {
    const Vec3 n{nx[i], ny[i], nz[i]};
    const bool fits = (piece.half[margin + i] > 0) & (dot(n, n) > 0);
    nx[i] = fits ? nx[i] : none;
  }
}

/// Sums over the windows of one size around the pixels x ... x + count - 1, which lie inside the image.
template <class Sums>
void sum_range(ImageView<const std::int32_t> q, int x, int y, int count, int half, Piece& piece) {
  Columns<Sums> columns;
  sum_columns<Sums>(q, x - half, y, count + 2 * half, half, columns);
  WindowRow windows;
  sum_windows<Sums>(columns, count, half, windows);
  keep_sums(windows, count, half, margin + x - piece.begin, piece);
}

template <class Sums>
void sum_all(ImageView<const std::int32_t> q, int y, int radius_px, unsigned present, Piece& piece) {
  const int end = piece.begin + piece.count;
  for (int half = 1; half <= radius_px; ++half) {
    if (!(present >> half & 1)) continue;
    const int first = half, behind = q.width - half;  // windows inside the image
    if (half == radius_px) {
      const int x = std::max(piece.begin, first);
      sum_range<Sums>(q, x, y, std::min(end, behind) - x, half, piece);
      continue;
    }
    for (int group = 0; group * lanes < piece.count; ++group) {
      if (!(piece.present[group] >> half & 1)) continue;
      const int x = std::clamp(piece.begin + group * lanes, first, behind - lanes);
      sum_range<Sums>(q, x, y, lanes, half, piece);
    }
  }
}

FACET_CPU_CLONES int largest_of(const std::int32_t* row, int width) {
  int largest = 0;
  for (int x = 0; x < width; ++x) largest = std::max(largest, row[x]);
  return largest;
}

}  // namespace

void NormalRows::fit(int y) const {
  const int width = inverse_depth.width, height = inverse_depth.height;
  const int* first = largest + std::max(y - radius_px, 0);
  const int* behind = largest + std::min(y + radius_px + 1, height);
  const std::int64_t window_px = (2 * radius_px + 1) * (2 * radius_px + 1);
  const bool narrow = *std::max_element(first, behind) * window_px <= std::numeric_limits<int>::max();
  const int pieces = (width + most - 1) / most;
  Piece piece{};
  for (int i = 0; i < pieces; ++i) {
    piece.begin = width * i / pieces;
    piece.count = width * (i + 1) / pieces - piece.begin;
    const unsigned present = find_halves(distance_px.row(y), radius_px, piece);
    if (narrow)
      sum_all<NarrowSums>(inverse_depth, y, radius_px, present, piece);
    else
      sum_all<WideSums>(inverse_depth, y, radius_px, present, piece);
    find_normals(piece, y, camera, normal.x.row(y) + piece.begin, normal.y.row(y) + piece.begin,
                 normal.z.row(y) + piece.begin);
  }
}

void find_largest(CpuExecutor& executor, ImageView<const std::int32_t> inverse_depth,
                  std::vector<int>& largest) {
  largest.resize(static_cast<std::size_t>(inverse_depth.height));
  executor.for_each_row(inverse_depth.height, [&](int y) {
    largest[static_cast<std::size_t>(y)] = largest_of(inverse_depth.row(y), inverse_depth.width);
  });
}

}  // namespace facet
