#pragma once

#include <cstdint>

#include "core/camera.hpp"
#include "core/normal_views.hpp"
#include "cpu/executor.hpp"

namespace facet {

/// NormalOp row by row. The window sums are integers, so that windows beside each other share the sums of
/// their columns; those of the largest windows are summed along the whole row.
struct NormalRows {
  static constexpr int most_radius_px = 16;
  static constexpr int least_width = 64;  ///< of an image; windows are summed in groups of lanes

  int radius_px;
  Camera camera;
  ImageView<const std::int32_t> inverse_depth;
  ImageView<const std::uint8_t> distance_px;
  NormalViews<float> normal;
  const int* largest;  ///< inverse depth of every row

  /// Fits the normals of a row. Where there is none, normal.x is not a number.
  void fit(int y) const;
};

/// Finds the largest inverse depth of every row.
void find_largest(CpuExecutor& executor, ImageView<const std::int32_t> inverse_depth,
                  std::vector<int>& largest);

}  // namespace facet
