#pragma once

#include "cpu/executor.hpp"
#include "stage/wiener.hpp"

namespace facet {

/// Same result as the generic statistics, to the bit: windows beside each other share the sums of their
/// columns. Compiled for radius 1 ... 3.
template <int radius, bool detrend>
void window_statistics(CpuExecutor& executor, const WienerStatisticsOp<radius, detrend>& op);

}  // namespace facet
