#pragma once

#include <string>

#include "dataset/registry.hpp"
#include "synth_io/write_benchmark.hpp"

namespace facet {

/// What `dataset info` prints of a synthetic benchmark: its data sets and frames, and how an experiment names
/// them.
std::string describe_benchmark(const DatasetSpec& spec);

/// What `synth` prints before it writes: frames, disk use, time.
std::string describe_estimate(const BenchmarkSpec& spec, int jobs);
/// And after: data sets, frames that are not available, objects that found no room.
std::string describe_summary(const BenchmarkSummary& summary, const std::filesystem::path& out);

}  // namespace facet
