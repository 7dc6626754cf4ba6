#pragma once

#include "cpu/executor.hpp"

namespace facet {

/// Same result as the generic labelling, by runs: union-find over the runs of a row that touch runs of the
/// row above.
void label_components(CpuExecutor& executor, ImageView<const float> depth_m,
                      ImageView<const std::uint8_t> edge, ImageView<std::int32_t> root);

}  // namespace facet
