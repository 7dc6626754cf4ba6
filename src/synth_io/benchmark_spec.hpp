#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "synth/set_spec.hpp"

namespace facet {

/// A synthetic benchmark as a YAML file describes it: one data set per entry of `sets`.
struct BenchmarkSpec {
  std::string name;
  std::vector<SetSpec> sets;
  std::string text;  ///< the file itself
};

/// Reads a spec (schema 1). Error{config} lists everything wrong in it as file:line:col: key: rule;
/// Error{data} where the file cannot be read.
BenchmarkSpec read_benchmark_spec(const std::filesystem::path& file);
/// The same for a text; `name` stands for the file in messages.
BenchmarkSpec parse_benchmark_spec(const std::string& text, const std::filesystem::path& name);

}  // namespace facet
