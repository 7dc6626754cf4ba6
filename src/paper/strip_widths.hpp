#pragma once

#include "paper/reproduction.hpp"

namespace facet {

/// Strips of that width in the scenes `strips` whose top face counts, and those of them that the first method
/// finds at IoU 0.5. The scenes hold strips of 3, 5, 8 and 12 mm, objects 1 to 4; the top is the largest
/// face. The frames are those that `run` scored.
Tally found_strips(const RunRecord& run, const std::pair<Experiment, Plan>& planned, int width_mm);

}  // namespace facet
