#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/shard.hpp"
#include "record/run_record.hpp"

namespace facet {

/// A finished shard of a run.
struct ShardRun {
  std::filesystem::path path;
  RunRecord run;
  Shard shard;
};

/// The shards of one run in the order of their numbers, every number once. Throws Error{data} where one is
/// missing, stands twice, is not finished, or is of another configuration or build.
std::vector<ShardRun> read_shards(const std::vector<std::filesystem::path>& paths);

/// Throws Error{data}: why runs cannot be joined.
[[noreturn]] void refuse_merge(const std::string& message);

}  // namespace facet
