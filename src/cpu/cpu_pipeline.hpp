#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/host_threads.hpp"
#include "pipeline/pipeline.hpp"

namespace facet {

/// The pipeline on the CPU with `threads` row bands inside a frame; results do not depend on their number.
/// `seed` feeds RANSAC. Throws Error{config} where a parameter is out of range.
std::unique_ptr<Pipeline> make_cpu_pipeline(const PipelineParams& params, std::uint64_t seed,
                                            int threads = 1);

/// `count` of them that take turns with the frames of one sequence: they share its past frames, so that the
/// first stage of a frame must follow that of the frame before.
std::vector<std::unique_ptr<Pipeline>> make_cpu_pipelines(int count, const PipelineParams& params,
                                                          std::uint64_t seed, int threads = 1);

/// Threads for what another back end does on the host.
std::unique_ptr<HostThreads> make_host_threads(int threads);

}  // namespace facet
