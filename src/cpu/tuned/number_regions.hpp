#pragma once

#include "cpu/executor.hpp"
#include "pipeline/number_regions.hpp"

namespace facet {

/// Same result as the generic numbering, but for b.root, which is left as it was: runs are found once, and
/// components are known by them.
int number_regions(CpuExecutor& executor, Buffers<CpuExecutor>& b, const PipelineParams& params,
                   const Camera& camera, RegionNumbering& numbering, Image<std::uint16_t>& numbered,
                   std::vector<RejectedRegion>& rejected);

}  // namespace facet
