#pragma once

#include <memory>
#include <span>

#include "dataset/registry.hpp"

namespace facet {

std::span<const OptionInfo> benchmark_options();

/// The frames of a synthetic benchmark, from its spec (rendered when they are first read, then kept in a
/// cache) or from a folder that was written from it: the same frames either way.
std::unique_ptr<Dataset> open_benchmark(const DatasetSpec& spec);

/// Compares the checksums of a written folder.
void inspect_benchmark(const DatasetSpec& spec, DatasetReport& report);

}  // namespace facet
