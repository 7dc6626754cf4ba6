#include "experiment/earlier_points.hpp"

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "dataset/checksum.hpp"
#include "experiment/config_writer.hpp"
#include "experiment/study_expansion.hpp"
#include "file/portable_name.hpp"
#include "prediction/prediction_io.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

using PointKey = std::pair<std::string, std::string>;  // method and data set
using PointHashes = std::map<PointKey, std::string>;

/// Hash of what decides the results of one method on one data set, wherever its files lie.
std::string point_hash(const Experiment& expanded, const MethodSpec& method, DatasetSpec dataset) {
  dataset.root.clear();
  dataset.annotations.clear();
  dataset.frames.clear();
  Experiment point = expanded;
  point.name.clear();
  point.methods = {method};
  point.datasets = {std::move(dataset)};
  point.timing = {};
  point.outputs.gallery = 0;
  point.ablations.clear();
  point.sweep.clear();
  const std::string text = write_config(point);
  return sha256_hex({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

PointHashes point_hashes(const Experiment& expanded) {
  PointHashes hashes;
  for (const MethodSpec& method : expanded.methods)
    for (const DatasetSpec& dataset : expanded.datasets)
      hashes[{method.name, dataset.name}] = point_hash(expanded, method, dataset);
  return hashes;
}

/// Runs beside this one, the newest first.
std::vector<fs::path> runs_beside(const fs::path& run) {
  std::vector<fs::path> runs;
  std::error_code absent;
  for (const auto& entry : fs::directory_iterator(run.parent_path(), absent))
    if (!entry.is_symlink() && entry.path() != run && fs::exists(entry.path() / "config.resolved.yaml"))
      runs.push_back(entry.path());
  std::sort(runs.rbegin(), runs.rend());
  return runs;
}

/// The files of a row; false where one is gone.
bool copy_outputs(const FrameRow& row, bool has_prediction, const fs::path& from, const fs::path& to) {
  std::vector<fs::path> files(row.pictures.begin(), row.pictures.end());
  const fs::path stem = fs::path("predictions") / row.method / row.dataset / portable_name(row.frame);
  const PredictionFiles prediction(stem);
  if (has_prediction) files.insert(files.end(), {prediction.labels, prediction.edges, prediction.surfaces});
  for (const fs::path& file : files)
    if (!fs::exists(from / file)) return false;
  for (const fs::path& file : files) {
    fs::create_directories((to / file).parent_path());
    fs::copy_file(from / file, to / file, fs::copy_options::overwrite_existing);
  }
  return true;
}

class Adoption {
 public:
  Adoption(const Experiment& expanded, const RunIdentity& identity, const RunDirectory& directory)
      : expanded_(expanded), identity_(identity), directory_(directory), wanted_(point_hashes(expanded)) {}

  EarlierPoints all() {
    for (const fs::path& run : runs_beside(directory_.path())) {
      try {
        take_from(run);
      } catch (const Error&) {
        continue;  // of another version, damaged, or not finished: nothing to reuse
      }
    }
    return std::move(found_);
  }

 private:
  void take_from(const fs::path& path) {
    const RunRecord run = read_run(path);
    if (run.manifest.build != identity_.build) return;
    const Experiment other = expand_study(load_experiment(path / "config.resolved.yaml").experiment,
                                          study_named(run.manifest.study));
    const PointHashes hashes = point_hashes(other);
    std::set<std::tuple<std::string, std::string, std::string>> taken;
    for (const FrameRow& row : run.frames) {
      const auto wanted = wanted_.find({row.method, row.dataset});
      const auto offered = hashes.find({row.method, row.dataset});
      if (wanted == wanted_.end() || offered == hashes.end() || wanted->second != offered->second) continue;
      if (row.status != FrameStatus::ok || !have_.insert({row.dataset, row.frame, row.method}).second)
        continue;
      if (!copy_outputs(row, expanded_.outputs.predictions, path, directory_.path())) continue;
      taken.insert({row.dataset, row.frame, row.method});
      found_.rows.push_back(row);
      found_.rows.back().config_hash = identity_.config_hash;
    }
    take_times(run, taken);
  }

  void take_times(const RunRecord& run,
                  const std::set<std::tuple<std::string, std::string, std::string>>& taken) {
    if (run.manifest.timing_threads != expanded_.timing.threads ||
        run.manifest.timing_repeats < expanded_.timing.repeats || run.timing.samples.empty())
      return;
    found_.timing.stages = run.timing.stages;
    for (const TimingSample& sample : run.timing.samples)
      if (taken.contains({sample.dataset, sample.frame, sample.method}))
        found_.timing.samples.push_back(sample);
    for (const IoTime& time : run.io_times)
      if (taken.contains({time.dataset, time.frame, time.method})) found_.io_times.push_back(time);
  }

  const Experiment& expanded_;
  const RunIdentity& identity_;
  const RunDirectory& directory_;
  PointHashes wanted_;
  std::set<std::tuple<std::string, std::string, std::string>> have_;
  EarlierPoints found_;
};

}  // namespace

EarlierPoints adopt_earlier_points(const Experiment& expanded, const RunIdentity& identity,
                                   const RunDirectory& directory) {
  EarlierPoints found = Adoption(expanded, identity, directory).all();
  std::string lines;
  for (const FrameRow& row : found.rows) lines += to_json_line(row);
  directory.publish("frames.jsonl", lines);
  return found;
}

}  // namespace facet
