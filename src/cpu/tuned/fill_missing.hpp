#pragma once

#include "cpu/executor.hpp"
#include "stage/fill_missing.hpp"

namespace facet {

/// Same result as the generic fill; looks at holes only, keeps a list of each hole's border, and shares the
/// window means between the pixels of a pass.
void fill_missing(CpuExecutor& executor, const FillParams& params, ImageView<float> depth_m,
                  ImageView<std::uint8_t> filled, const FillScratch& scratch);

}  // namespace facet
