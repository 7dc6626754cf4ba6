#include "experiment/run_description.hpp"

#include <fmt/format.h>
#include <map>

#include "dataset/checksum.hpp"
#include "experiment/build_info.hpp"
#include "experiment/config_writer.hpp"
#include "experiment/environment.hpp"
#include "experiment/study_expansion.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

/// The same experiment wherever its file lies: no path is relative to another place than the data root.
Experiment with_whole_paths(Experiment experiment) {
  const auto whole = [](std::filesystem::path& path) {
    if (!path.empty() && !path.string().starts_with("${")) path = std::filesystem::weakly_canonical(path);
  };
  for (DatasetSpec& spec : experiment.datasets) {
    whole(spec.root);
    whole(spec.annotations);
  }
  for (MethodSpec& method : experiment.methods) whole(method.folder);
  return experiment;
}

std::vector<std::string> printable_all(const std::vector<std::string>& texts) {
  std::vector<std::string> result;
  for (const std::string& text : texts) result.push_back(escaped_utf8(text));
  return result;
}

}  // namespace

std::string config_hash(const Experiment& experiment, const RunOptions& options) {
  const std::string text =
      write_config(experiment) + fmt::format("filter: {}\nlimit: {}\nstudy: {}\n", options.filter,
                                             options.limit.value_or(0), static_cast<int>(options.study));
  return sha256_hex({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

RunIdentity make_identity(const Experiment& experiment, const RunOptions& options, const Plan& plan) {
  const bool is_cpu = plan.backend.backend == Backend::cpu;
  return {config_hash(experiment, options),
          build_identity() + (is_cpu ? "" : fmt::format("+{}", backend_name(plan.backend.backend)))};
}

Manifest make_manifest(const Experiment& experiment, const RunOptions& options, const Plan& plan,
                       const RunIdentity& identity) {
  Manifest manifest;
  manifest.experiment = experiment.name;
  manifest.study = study_name(options.study);
  manifest.shard = options.shard.text();
  manifest.command = printable_all(options.command);
  manifest.config_hash = identity.config_hash;
  manifest.build = identity.build;
  manifest.backend = backend_name(plan.backend.backend);
  manifest.jobs = options.jobs;
  manifest.started_utc = utc_now();
  for (const MethodSpec& method : experiment.methods) manifest.methods.push_back(method.name);
  for (const PlannedDataset& planned : plan.datasets) manifest.datasets.push_back(planned.spec.name);
  manifest.frames_planned = static_cast<int>(plan.frame_count());
  manifest.timing_warmup = experiment.timing.warmup;
  manifest.timing_repeats = experiment.timing.repeats;
  manifest.timing_threads = experiment.timing.threads;
  return manifest;
}

void publish_description(const RunDirectory& directory, const Experiment& source, const Manifest& manifest) {
  directory.publish("manifest.json", to_json(manifest));
  directory.publish("config.resolved.yaml", write_config(with_whole_paths(source)));
  directory.publish("env.json", environment_json());
  directory.become_latest();
}

void publish_lock(const RunDirectory& directory, const Plan& plan, const DataLock& lock) {
  std::map<std::string, std::filesystem::path> roots;
  for (const PlannedDataset& planned : plan.datasets) {
    const std::filesystem::path folder = planned.data->folder();
    roots[planned.spec.name] = folder.empty() ? planned.spec.root : folder;
  }
  directory.publish("dataset.lock.json", lock.to_json(roots));
}

}  // namespace facet
