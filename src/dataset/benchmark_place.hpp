#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/reader_options.hpp"
#include "synth/frame_plan.hpp"
#include "synth_io/benchmark_spec.hpp"

namespace facet {

/// A synthetic benchmark and where its frames are.
struct BenchmarkPlace {
  BenchmarkSpec spec;
  std::filesystem::path folder;  ///< in the layout of write_benchmark()
  bool rendered = false;         ///< the folder is a cache: a frame is rendered when it is first read
};

/// One data set of a benchmark: a set, or one sequence of a set.
struct BenchmarkPart {
  std::string name;  ///< "boxes", "moving/mixed_000": its folder in the benchmark
  SetSpec set;
  std::vector<PlannedFrame> frames;  ///< those there are; levels outside the sensor's range are left out
};

/// Whether `root` is the file of a spec, or a folder that `facet synth` wrote or began to write.
bool is_benchmark(const std::filesystem::path& root);

/// Reads the spec. The cache of a spec is named by its content, the seed and the version of the generator,
/// and lies below the option `cache`, else $XDG_CACHE_HOME/facet, else ~/.cache/facet. Throws Error{data}
/// where `root` is no benchmark or an unfinished one, Error{config} where the spec is wrong or no cache can
/// be named.
BenchmarkPlace find_benchmark(const std::filesystem::path& root, const ReaderOptions& options);

/// Every data set of it, in the order of the spec.
std::vector<BenchmarkPart> benchmark_parts(const BenchmarkSpec& spec);
/// The frames of a set that are left out, each with its reason: "distance_m_0.4_000: n/a (range)".
std::vector<std::string> absent_frames(const SetSpec& set);

}  // namespace facet
