#include "experiment/merge.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "experiment/publish_rows.hpp"
#include "experiment/shard_runs.hpp"
#include "experiment/study_expansion.hpp"
#include "experiment/wanted_galleries.hpp"
#include "file/file_bytes.hpp"
#include "record/run_record.hpp"
#include "report/timing_summary.hpp"
#include "report/write_report.hpp"
#include "score/intervals.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::vector<FrameRow> joined_rows(const std::vector<ShardRun>& shards) {
  std::vector<FrameRow> rows;
  for (const ShardRun& s : shards) rows.insert(rows.end(), s.run.frames.begin(), s.run.frames.end());
  std::sort(rows.begin(), rows.end(), row_before);
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (!row_before(rows[i - 1], rows[i]))
      refuse_merge(fmt::format("{}/{} of method {} stands in two shards", rows[i].dataset, rows[i].frame,
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
          refuse_merge(
              fmt::format("{}: {} of data set {} has another checksum", printable(s.path), file, name));
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
    for (const char* folder : {"predictions", "overlays", "strips", "programs"})
      if (fs::exists(s.path / folder)) fs::copy(s.path / folder, directory.path() / folder, options);
  for (const char* file : {"config.resolved.yaml", "env.json"})
    write_file_atomically(directory.path() / file, read_file_bytes(shards.front().path / file));
}

/// Takes the picture that a shard drew of the entry.
void take_picture(const std::vector<ShardRun>& shards, const RunDirectory& directory,
                  const WantedGallery& gallery, GalleryEntry& entry) {
  const auto is_same = [&](const GalleryEntry& other) {
    return other.dataset == entry.dataset && other.frame == entry.frame && other.method == entry.method;
  };
  for (const ShardRun& s : shards) {
    const std::vector<GalleryEntry>& kept = s.run.*gallery.kept;
    const auto found = std::find_if(kept.begin(), kept.end(), is_same);
    if (found == kept.end()) continue;
    entry.picture = found->picture;
    if (!entry.picture.empty() && fs::exists(s.path / entry.picture))
      write_file_atomically(directory.path() / entry.picture, read_file_bytes(s.path / entry.picture));
  }
}

void join_galleries(const std::vector<ShardRun>& shards, const std::vector<FrameRow>& rows,
                    const OutputOptions& outputs, const RunDirectory& directory, Manifest& manifest) {
  for (WantedGallery& gallery : wanted_galleries(outputs, rows)) {
    std::erase(manifest.notes, gallery.why_empty);  // what a shard said of its part
    if (gallery.entries.empty()) {
      manifest.notes.emplace_back(gallery.why_empty);
      continue;
    }
    for (GalleryEntry& entry : gallery.entries) take_picture(shards, directory, gallery, entry);
    directory.publish(gallery.file, to_json(gallery.entries));
  }
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
  Manifest manifest = joined_manifest(shards, rows, command);
  const RunDirectory directory =
      RunDirectory::create(out, manifest.experiment, manifest.config_hash, manifest.build);
  copy_outputs(shards, directory);
  directory.publish("dataset.lock.json", lock);
  const Experiment experiment = load_experiment(shards.front().path / "config.resolved.yaml").experiment;
  publish_rows(directory, experiment, manifest, rows);
  join_galleries(shards, rows, experiment.outputs, directory, manifest);
  publish_times(shards, directory);
  directory.publish("manifest.json", to_json(manifest));
  publish_study(directory, experiment, study_named(manifest.study));
  directory.become_latest();
  return {manifest.exit_code, directory.path(), write_report(directory.path(), {"md", "html", "tex"})};
}

}  // namespace facet
