#include "cpu/tuned/labelling.hpp"

#include <algorithm>

#include "cpu/run_forest.hpp"

namespace facet {

void label_components(CpuExecutor& executor, ImageView<const float> depth_m,
                      ImageView<const std::uint8_t> edge, ImageView<std::int32_t> root) {
  RunForest runs(executor, depth_m, edge);
  // Raster index of the first pixel of every run's set; sets are named by their first run.
  std::vector<int>& name = executor.scratch().names;
  name.resize(static_cast<std::size_t>(runs.count()));
  for (int y = 0; y < root.height; ++y) {
    std::int32_t* at = root.row(y);
    for (int r = runs.first_of_row(y); r < runs.first_of_row(y + 1); ++r) {
      const int first = runs.set_of(r);
      if (first == r) name[static_cast<std::size_t>(r)] = y * root.width + runs.begin(r);
      at = std::fill_n(at, root.row(y) + runs.begin(r) - at, -1);
      at = std::fill_n(at, runs.end(r) - runs.begin(r), name[static_cast<std::size_t>(first)]);
    }
    std::fill_n(at, root.row(y) + root.width - at, -1);
  }
}

}  // namespace facet
