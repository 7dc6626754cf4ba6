#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "synth/set_spec.hpp"

namespace facet {

/// A synthetic benchmark as a YAML file describes it: one data set per entry of `sets`.
struct BenchmarkSpec {
  std::string name;
  std::vector<SetSpec> sets;
  std::string text;  ///< the file itself, with the seed that was put in
};

/// Reads a spec (schema 1). `seed` stands in for the key `seed` of the file; sets with a seed of their own
/// keep it. Error{config} lists everything wrong in it as file:line:col: key: rule, also where the file
/// cannot be read.
BenchmarkSpec read_benchmark_spec(const std::filesystem::path& file,
                                  std::optional<std::uint64_t> seed = std::nullopt);
/// The same for a text; `name` stands for the file in messages.
BenchmarkSpec parse_benchmark_spec(const std::string& text, const std::filesystem::path& name);

}  // namespace facet
