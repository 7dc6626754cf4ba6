#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "synth_io/benchmark_spec.hpp"

namespace facet {

/// What writing a benchmark will cost, by rule of thumb; to be shown before writing.
struct BenchmarkEstimate {
  std::size_t frames = 0;
  double megabytes = 0;
  double seconds = 0;  ///< on one core
};
BenchmarkEstimate estimate_benchmark(const BenchmarkSpec& spec);

/// What was written.
struct BenchmarkSummary {
  std::size_t frames = 0;
  std::vector<std::filesystem::path> folders;  ///< data sets that the `folder` reader opens
  std::vector<std::string> not_available;      ///< "set/frame: n/a (range)"
  std::vector<std::string> shortfalls;         ///< "set/frame: 17 of 20 objects found room"
};

/// Writes every set of the spec below `out`: one data set per set, or per sequence of a set with sequences,
/// with dataset.yaml, depth/, color/, truth/ (annotation, object masks, geometry), and poses.txt for a
/// sequence; then spec.yaml, version.txt and the checksums. The bytes do not depend on `jobs`. `progress` is
/// called with the number of frames done, one call at a time. As long as something is missing, `out` holds
/// the file `unfinished_mark` and no reader takes it for a data set; the same call completes it. Error{usage}
/// where `out` exists and is neither an empty folder nor the unfinished benchmark of the same spec,
/// Error{internal} where it cannot be written.
BenchmarkSummary write_benchmark(const BenchmarkSpec& spec, const std::filesystem::path& out, int jobs,
                                 const std::function<void(std::size_t)>& progress = {});

}  // namespace facet
