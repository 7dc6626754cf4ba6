#include "cpu/tuned/number_regions.hpp"

#include "cpu/run_forest.hpp"

namespace facet {

int number_regions(CpuExecutor& executor, Buffers<CpuExecutor>& b, const PipelineParams& params,
                   const Camera& camera, RegionNumbering& numbering, Image<std::uint16_t>& numbered,
                   std::vector<RejectedRegion>& rejected) {
  RunForest runs(executor, b.depth.view(), b.edge.view());
  std::vector<int>& first_of_component = executor.scratch().names;
  first_of_component.resize(static_cast<std::size_t>(runs.count()));
  for (int r = 0; r < runs.count(); ++r) first_of_component[static_cast<std::size_t>(r)] = runs.set_of(r);
  const int count =
      numbering.number({runs.begins(), runs.ends(), runs.row_starts(), first_of_component}, b.depth.view(),
                       b.filled.view(), camera, params.validation, b.label.view(), rejected);
  if (params.contours.mode == ContourMode::edge_map) executor.download(b.label.view(), numbered.view());
  return count;
}

}  // namespace facet
