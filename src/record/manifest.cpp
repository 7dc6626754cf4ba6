#include "record/manifest.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::array<std::string_view, 4> status_names{"running", "complete", "partial", "failed"};

RunStatus status_from(const std::string& name) {
  for (std::size_t i = 0; i < status_names.size(); ++i)
    if (status_names[i] == name) return static_cast<RunStatus>(i);
  throw Error(ErrorKind::data, "unknown run status '" + name + "'");
}

/// THE list of the manifest's keys beside schema_version and status.
template <class M, class Visitor>
void visit_manifest(M& m, Visitor&& visit) {
  visit("experiment", m.experiment);
  visit("command", m.command);
  visit("config_hash", m.config_hash);
  visit("build", m.build);
  visit("backend", m.backend);
  visit("jobs", m.jobs);
  visit("started_utc", m.started_utc);
  visit("finished_utc", m.finished_utc);
  visit("exit_code", m.exit_code);
  visit("methods", m.methods);
  visit("datasets", m.datasets);
  visit("frames_planned", m.frames_planned);
  visit("frames_ok", m.frames_ok);
  visit("frames_data_error", m.frames_data_error);
  visit("frames_method_error", m.frames_method_error);
  visit("timing_warmup", m.timing_warmup);
  visit("timing_repeats", m.timing_repeats);
  visit("timing_threads", m.timing_threads);
  visit("notes", m.notes);
}

/// Keys that manifests of earlier versions lack.
template <class M, class Visitor>
void visit_later_keys(M& m, Visitor&& visit) {
  visit("study", m.study);
  visit("shard", m.shard);
}

}  // namespace

std::string_view status_name(RunStatus status) {
  return status_names[static_cast<std::size_t>(status)];
}

std::string to_json(const Manifest& manifest) {
  Json json;
  json["schema_version"] = Manifest::schema_version;
  json["status"] = std::string(status_name(manifest.status));
  const auto write = [&](const char* key, const auto& value) { json[key] = value; };
  visit_manifest(manifest, write);
  visit_later_keys(manifest, write);
  return json.dump(2) + '\n';
}

Manifest manifest_from_json(std::string_view text) {
  Manifest manifest;
  try {
    const Json json = Json::parse(text);
    if (json.at("schema_version") != Manifest::schema_version)
      throw Error(ErrorKind::data,
                  "manifest: schema_version " + json.at("schema_version").dump() + " is not 1");
    manifest.status = status_from(json.at("status").get<std::string>());
    visit_manifest(manifest, [&](const char* key, auto& value) { json.at(key).get_to(value); });
    visit_later_keys(manifest, [&](const char* key, auto& value) {
      if (json.contains(key)) json.at(key).get_to(value);
    });
  } catch (const nlohmann::json::exception& e) {
    throw Error(ErrorKind::data, std::string("not a manifest: ") + e.what());
  }
  return manifest;
}

}  // namespace facet
