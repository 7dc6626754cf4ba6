#pragma once

#include <filesystem>

#include "synth_io/benchmark_spec.hpp"

namespace facet {

/// Changes whenever the same spec gives other bytes.
inline constexpr const char* generator_version = "3";

/// Says in a folder that its benchmark is not complete, and what it is made from.
inline constexpr const char* unfinished_mark = "unfinished.txt";

/// What decides the bytes of a benchmark: version of the generator and text of the spec.
std::string benchmark_content(const BenchmarkSpec& spec);

/// Makes a folder for a benchmark and marks it as unfinished, or takes up one where the same benchmark was
/// left unfinished. Error{usage} where `folder` exists and is neither that nor empty, Error{internal} where
/// it cannot be made.
void open_benchmark_folder(const std::filesystem::path& folder, const BenchmarkSpec& spec);
/// Writes version.txt, spec.yaml and the checksums of all files, and takes the mark away.
void complete_benchmark_folder(const std::filesystem::path& folder, const BenchmarkSpec& spec);
/// Error{data} where the folder, or the benchmark that it is a part of, is marked as unfinished.
void require_finished(const std::filesystem::path& folder);

}  // namespace facet
