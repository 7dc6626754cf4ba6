#include "experiment/shard_runs.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

ShardRun read_shard(const std::filesystem::path& path) {
  ShardRun shard{path, read_run(path), {}};
  const Manifest& m = shard.run.manifest;
  if (m.shard.empty()) refuse_merge(printable(path) + ": not run with --shard");
  shard.shard = parse_shard(m.shard);
  const auto rows = static_cast<int>(shard.run.frames.size());
  if (m.finished_utc.empty() || m.status == RunStatus::partial || rows != m.frames_planned)
    refuse_merge(fmt::format("{}: not finished, it has {} of {} rows; complete it with --resume",
                             printable(path), rows, m.frames_planned));
  return shard;
}

}  // namespace

void refuse_merge(const std::string& message) {
  throw Error(ErrorKind::data, "merge: " + message);
}

std::vector<ShardRun> read_shards(const std::vector<std::filesystem::path>& paths) {
  std::vector<ShardRun> shards;
  for (const std::filesystem::path& path : paths) shards.push_back(read_shard(path));
  std::sort(shards.begin(), shards.end(),
            [](const ShardRun& a, const ShardRun& b) { return a.shard.index < b.shard.index; });
  const ShardRun& first = shards.front();
  for (const ShardRun& s : shards) {
    const Manifest &m = s.run.manifest, &n = first.run.manifest;
    if (m.config_hash != n.config_hash)
      refuse_merge(
          fmt::format("{} has another configuration than {}", printable(s.path), printable(first.path)));
    if (m.build != n.build)
      refuse_merge(fmt::format("{} is of build {}, {} of {}", printable(s.path), m.build,
                               printable(first.path), n.build));
    if (s.shard.count != first.shard.count)
      refuse_merge(fmt::format("{} is shard {}, {} is {}", printable(s.path), m.shard, printable(first.path),
                               n.shard));
  }
  for (int i = 1; i <= first.shard.count; ++i) {
    const auto count =
        std::count_if(shards.begin(), shards.end(), [&](const auto& s) { return s.shard.index == i; });
    if (count == 0) refuse_merge(fmt::format("shard {}/{} is missing", i, first.shard.count));
    if (count > 1) refuse_merge(fmt::format("shard {}/{} stands {} times", i, first.shard.count, count));
  }
  return shards;
}

}  // namespace facet
