#pragma once

#include "pipeline/result.hpp"

namespace facet {

/// Throws Error{data} where a frame cannot be right: negative or non-finite depth, focal lengths that are not
/// positive, a principal point that is not finite, counts of another size. (Missing depth is 0 and fine.)
void check_frame(const FrameInput& frame);

}  // namespace facet
