#pragma once

#include "cpu/executor.hpp"
#include "stage/temporal_average.hpp"

namespace facet {

/// Same result as the generic average, to the bit; a row at a time, so that the sort of a pixel's readings
/// becomes minima and maxima of whole rows.
void temporal_average(CpuExecutor& executor, const TemporalParams& params, const DepthNoise& noise,
                      const TemporalHistory<CpuExecutor>& history, ImageView<float> out);

}  // namespace facet
