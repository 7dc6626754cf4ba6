#pragma once

#include "cpu/executor.hpp"

namespace facet {

/// Same result as the generic thinning; after the first round only pixels beside a deleted one are looked at
/// again.
void thin(CpuExecutor& executor, ImageView<std::uint8_t> edge, ImageView<std::uint8_t> mark);

}  // namespace facet
