#include "cpu/tuned/normals.hpp"

#include "stage/normals.hpp"

namespace facet {
namespace {

/// Sums of q, x q and y q over all pixels above and to the left, side by side for one look-up.
struct Corner {
  std::int64_t q, x_q, y_q, unused;
};

WindowSums window_sums(const Corner* table, int pitch, int x, int y, int half) {
  const Corner& a = table[static_cast<std::ptrdiff_t>(y - half) * pitch + x - half];
  const Corner& b = table[static_cast<std::ptrdiff_t>(y - half) * pitch + x + half + 1];
  const Corner& c = table[static_cast<std::ptrdiff_t>(y + half + 1) * pitch + x - half];
  const Corner& d = table[static_cast<std::ptrdiff_t>(y + half + 1) * pitch + x + half + 1];
  WindowSums sums;
  sums.q = d.q - b.q - c.q + a.q;
  sums.dx_q = d.x_q - b.x_q - c.x_q + a.x_q - x * sums.q;
  sums.dy_q = d.y_q - b.y_q - c.y_q + a.y_q - y * sums.q;
  return sums;
}

void build_table(ImageView<const std::int32_t> inverse_depth, Corner* table) {
  const int pitch = inverse_depth.width + 1;
  std::fill_n(table, pitch, Corner{});
  for (int y = 0; y < inverse_depth.height; ++y) {
    const Corner* above = table + static_cast<std::ptrdiff_t>(y) * pitch;
    Corner* here = table + static_cast<std::ptrdiff_t>(y + 1) * pitch;
    Corner row{};
    here[0] = row;
    for (int x = 0; x < inverse_depth.width; ++x) {
      const std::int64_t q = inverse_depth(x, y);
      row.q += q;
      row.x_q += x * q;
      row.y_q += y * q;
      here[x + 1] = {above[x + 1].q + row.q, above[x + 1].x_q + row.x_q, above[x + 1].y_q + row.y_q, 0};
    }
  }
}

}  // namespace

void fit_normals(CpuExecutor& executor, int radius_px, const Camera& camera,
                 ImageView<const std::int32_t> inverse_depth, ImageView<const std::uint8_t> distance_px,
                 ImageView<Vec3> normal) {
  static_assert(sizeof(Corner) == 4 * sizeof(std::int64_t));
  const int pitch = inverse_depth.width + 1;
  std::vector<std::int64_t>& memory = executor.scratch().sums;
  memory.resize(4 * static_cast<std::size_t>(pitch) * static_cast<std::size_t>(inverse_depth.height + 1));
  auto* table = reinterpret_cast<Corner*>(memory.data());
  build_table(inverse_depth, table);
  for (int y = 0; y < normal.height; ++y)
    for (int x = 0; x < normal.width; ++x) {
      const int half = fit_half_side(distance_px(x, y), radius_px);
      normal(x, y) =
          half > 0 ? normal_from_sums(window_sums(table, pitch, x, y, half), half, x, y, camera) : Vec3{};
    }
}

}  // namespace facet
