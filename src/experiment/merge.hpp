#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/runner.hpp"

namespace facet {

/// Joins the shards of a run into a run directory below `out`, the same as if it had never been cut:
/// predictions, pictures, rows, metrics, times and report. Throws Error{data} where a shard is missing,
/// stands twice, is not finished, or is of another configuration, build or data.
RunOutcome merge_runs(const std::vector<std::filesystem::path>& shards, const std::filesystem::path& out,
                      const std::vector<std::string>& command);

}  // namespace facet
