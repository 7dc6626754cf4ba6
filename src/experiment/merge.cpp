#include "experiment/merge.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "experiment/publish_rows.hpp"
#include "experiment/shard.hpp"
#include "experiment/study_expansion.hpp"
#include "file/file_bytes.hpp"
#include "record/run_record.hpp"
#include "report/timing_summary.hpp"
#include "report/write_report.hpp"
#include "score/intervals.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct ShardRun {
  fs::path path;
  RunRecord run;
  Shard shard;
};

[[noreturn]] void refuse(const std::string& message) {
  throw Error(ErrorKind::data, "merge: " + message);
}

ShardRun read_shard(const fs::path& path) {
  ShardRun shard{path, read_run(path), {}};
  const Manifest& m = shard.run.manifest;
  if (m.shard.empty()) refuse(printable(path) + ": not run with --shard");
  shard.shard = parse_shard(m.shard);
  const auto rows = static_cast<int>(shard.run.frames.size());
  if (m.finished_utc.empty() || m.status == RunStatus::partial || rows != m.frames_planned)
    refuse(fmt::format("{}: not finished, it has {} of {} rows; complete it with --resume", printable(path),
                       rows, m.frames_planned));
  return shard;
}

/// In the order of their numbers; every number once.
std::vector<ShardRun> read_shards(const std::vector<fs::path>& paths) {
  std::vector<ShardRun> shards;
  for (const fs::path& path : paths) shards.push_back(read_shard(path));
  std::sort(shards.begin(), shards.end(),
            [](const ShardRun& a, const ShardRun& b) { return a.shard.index < b.shard.index; });
  const ShardRun& first = shards.front();
  for (const ShardRun& s : shards) {
    const Manifest &m = s.run.manifest, &n = first.run.manifest;
    if (m.config_hash != n.config_hash)
      refuse(fmt::format("{} has another configuration than {}", printable(s.path), printable(first.path)));
    if (m.build != n.build)
      refuse(fmt::format("{} is of build {}, {} of {}", printable(s.path), m.build, printable(first.path),
                         n.build));
    if (s.shard.count != first.shard.count)
      refuse(fmt::format("{} is shard {}, {} is {}", printable(s.path), m.shard, printable(first.path),
                         n.shard));
  }
  for (int i = 1; i <= first.shard.count; ++i) {
    const auto count =
        std::count_if(shards.begin(), shards.end(), [&](const auto& s) { return s.shard.index == i; });
    if (count == 0) refuse(fmt::format("shard {}/{} is missing", i, first.shard.count));
    if (count > 1) refuse(fmt::format("shard {}/{} stands {} times", i, first.shard.count, count));
  }
  return shards;
}

std::vector<FrameRow> joined_rows(const std::vector<ShardRun>& shards) {
  std::vector<FrameRow> rows;
  for (const ShardRun& s : shards) rows.insert(rows.end(), s.run.frames.begin(), s.run.frames.end());
  std::sort(rows.begin(), rows.end(), row_before);
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (!row_before(rows[i - 1], rows[i]))
      refuse(fmt::format("{}/{} of method {} stands in two shards", rows[i].dataset, rows[i].frame,
                         rows[i].method));
  return rows;
}

/// Checksums of all shards. A file that two of them read must be the same.
std::string joined_lock(const std::vector<ShardRun>& shards) {
  Json joined = Json::object();
  std::map<std::string, std::map<fs::path, std::string>> hashes;
  for (const ShardRun& s : shards) {
    const auto bytes = read_file_bytes(s.path / "dataset.lock.json");
    const Json lock = Json::parse(bytes.begin(), bytes.end());
    for (const auto& [name, dataset] : lock.items()) {
      if (!joined.contains(name)) joined[name]["root"] = dataset.at("root");
      for (const auto& [file, hash] : dataset.at("sha256").items())
        if (hashes[name].emplace(file, hash).first->second != hash)
          refuse(fmt::format("{}: {} of data set {} has another checksum", printable(s.path), file, name));
    }
  }
  for (auto& [name, dataset] : joined.items()) {
    dataset["sha256"] = Json::object();
    for (const auto& [file, hash] : hashes[name]) dataset["sha256"][file.string()] = hash;
  }
  return joined.dump(2) + '\n';
}

Manifest joined_manifest(const std::vector<ShardRun>& shards, const std::vector<FrameRow>& rows,
                         const std::vector<std::string>& command) {
  Manifest m = shards.front().run.manifest;
  m.shard.clear();
  m.command = command;
  m.frames_planned = static_cast<int>(rows.size());
  m.frames_ok = m.frames_data_error = m.frames_method_error = 0;
  count_rows(rows, m);
  for (const ShardRun& s : shards) {
    const Manifest& part = s.run.manifest;
    m.started_utc = std::min(m.started_utc, part.started_utc);
    m.finished_utc = std::max(m.finished_utc, part.finished_utc);
    if (part.exit_code != 0) m.exit_code = part.exit_code, m.status = RunStatus::failed;
    for (const std::string& note : part.notes)
      if (std::find(m.notes.begin(), m.notes.end(), note) == m.notes.end()) m.notes.push_back(note);
  }
  m.notes.push_back(fmt::format("merged from {} shards", shards.size()));
  return m;
}

void copy_outputs(const std::vector<ShardRun>& shards, const RunDirectory& directory) {
  constexpr auto options = fs::copy_options::recursive | fs::copy_options::overwrite_existing;
  for (const ShardRun& s : shards)
    for (const char* folder : {"predictions", "overlays"})
      if (fs::exists(s.path / folder)) fs::copy(s.path / folder, directory.path() / folder, options);
  for (const char* file : {"config.resolved.yaml", "env.json"})
    write_file_atomically(directory.path() / file, read_file_bytes(shards.front().path / file));
}

void publish_times(const std::vector<ShardRun>& shards, const RunDirectory& directory) {
  TimingTable table;
  std::vector<IoTime> io_times;
  std::vector<double> medians;
  Calibration calibration{0, 0, std::numeric_limits<double>::infinity()};
  for (const ShardRun& s : shards) {
    if (table.stages.empty()) table.stages = s.run.timing.stages;
    table.samples.insert(table.samples.end(), s.run.timing.samples.begin(), s.run.timing.samples.end());
    io_times.insert(io_times.end(), s.run.io_times.begin(), s.run.io_times.end());
    if (!s.run.calibration) continue;
    medians.push_back(s.run.calibration->median_ms);
    calibration.repeats += s.run.calibration->repeats;
    calibration.min_ms = std::min(calibration.min_ms, s.run.calibration->min_ms);
  }
  if (table.samples.empty()) return;
  if (!medians.empty()) {
    std::sort(medians.begin(), medians.end());
    calibration.median_ms = sorted_quantile(medians, 0.5);
    directory.publish("timing/calibration.json", to_json(calibration));
  }
  directory.publish("timing/io.csv", to_csv(io_times));
  directory.publish("timing/stages.csv", stages_csv(summarize_timing(table)));
  directory.publish("timing/samples.csv", to_csv(table));
}

}  // namespace

RunOutcome merge_runs(const std::vector<fs::path>& paths, const fs::path& out,
                      const std::vector<std::string>& command) {
  const std::vector<ShardRun> shards = read_shards(paths);
  const std::vector<FrameRow> rows = joined_rows(shards);
  const std::string lock = joined_lock(shards);
  const Manifest manifest = joined_manifest(shards, rows, command);
  const RunDirectory directory =
      RunDirectory::create(out, manifest.experiment, manifest.config_hash, manifest.build);
  copy_outputs(shards, directory);
  directory.publish("dataset.lock.json", lock);
  const Experiment experiment = load_experiment(shards.front().path / "config.resolved.yaml").experiment;
  publish_rows(directory, experiment, manifest, rows);
  publish_times(shards, directory);
  directory.publish("manifest.json", to_json(manifest));
  publish_study(directory, experiment, study_named(manifest.study));
  directory.become_latest();
  return {manifest.exit_code, directory.path(), write_report(directory.path(), {"md", "html", "tex"})};
}

}  // namespace facet
