#pragma once

#include "cpu/executor.hpp"
#include "stage/wiener.hpp"

namespace facet {

/// Same result as the generic filter, to the bit: windows beside each other share the sums of their columns,
/// and a piece of a row is filtered while its statistics are at hand. Where the noise is the mean of all
/// variances, the statistics pass through the images `mean_m` and `variance_m2`; otherwise those are left
/// alone.
void wiener(CpuExecutor& executor, const WienerParams& params, const DepthNoise& sensor,
            ImageView<const float> depth_m, ImageView<float> mean_m, ImageView<float> variance_m2,
            ImageView<float> out);

}  // namespace facet
