#pragma once

#include <cstdint>
#include <memory>

#include "pipeline/pipeline.hpp"

namespace facet {

/// The pipeline on the CPU with `threads` row bands inside a frame; results do not depend on their number.
/// `seed` feeds RANSAC. Throws Error{config} where a parameter is out of range.
std::unique_ptr<Pipeline> make_cpu_pipeline(const PipelineParams& params, std::uint64_t seed,
                                            int threads = 1);

}  // namespace facet
