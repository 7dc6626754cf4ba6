#include "record/metrics_summary.hpp"

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "score/summary.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;

Json optional_number(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

void add_interval(Json& json, const std::optional<Interval>& interval) {
  json["lo"] = interval ? Json(interval->lo) : Json(nullptr);
  json["hi"] = interval ? Json(interval->hi) : Json(nullptr);
}

Json micro_of(const MetricSummary& metric) {
  Json json;
  if (!metric.not_provided.empty()) return {{"value", nullptr}, {"reason", metric.not_provided}};
  if (metric.is_proportion) {
    json["hit"] = metric.hit;
    json["n"] = metric.n;
  }
  json["value"] = optional_number(metric.micro);
  add_interval(json, metric.micro_interval);
  if (!metric.micro) json["reason"] = "nothing to count (n = 0)";
  return json;
}

Json macro_of(const MetricSummary& metric) {
  if (!metric.not_provided.empty()) return {{"value", nullptr}, {"reason", metric.not_provided}};
  Json json;
  json["value"] = optional_number(metric.macro);
  add_interval(json, metric.macro_interval);
  json["frames"] = metric.macro_frames;
  json["frames_without"] = metric.frames_without;
  json["frames_not_annotated"] = metric.frames_not_annotated;
  if (!metric.macro) json["reason"] = "no frame has anything to count";
  return json;
}

Json error_of(const ErrorSummary& error) {
  if (!error.not_provided.empty())
    return {{"p50", nullptr}, {"p95", nullptr}, {"n", 0}, {"reason", error.not_provided}};
  return {{"p50", error.p50}, {"p95", error.p95}, {"n", error.n}};
}

Json curve_of(const CurveSummary& curve) {
  if (!curve.not_provided.empty()) return {{"points", nullptr}, {"reason", curve.not_provided}};
  Json points = Json::array();
  for (std::size_t i = 0; i < curve.thresholds.size(); ++i)
    points.push_back({curve.thresholds[i], curve.tallies[i].hit, curve.tallies[i].n});
  return {{"points", points}};
}

void add_scores(Json& json, const ScoreCollection& collection, const ScoreGroups& groups) {
  const ScoreSummary summary = summarise_scores(collection);
  for (const char* part : {"micro", "macro", "errors", "curves"}) json[part] = Json::object();
  for (const MetricSummary& metric : summary.metrics) {
    if (!groups.contains(metric.name)) continue;
    json["micro"][metric.name] = micro_of(metric);
    json["macro"][metric.name] = macro_of(metric);
  }
  if (groups.poses)
    for (const ErrorSummary& error : summary.errors) json["errors"][error.name] = error_of(error);
  for (const CurveSummary& curve : summary.curves)
    if (groups.contains(curve.name)) json["curves"][curve.name] = curve_of(curve);
  json["strata"] = Json::array();
  for (const Stratum& stratum : stratify_scores(collection)) {
    Json entry{{"axis", stratum.axis}, {"label", stratum.label}, {"frames", stratum.summary.counts.n_total}};
    for (const MetricSummary& metric : stratum.summary.metrics)
      if (groups.contains(metric.name)) entry["micro"][metric.name] = micro_of(metric);
    json["strata"].push_back(std::move(entry));
  }
}

Json result_of(const std::string& method, const std::string& dataset, const std::vector<FrameRow>& rows,
               const ScoreGroups& groups) {
  ScoreCollection collection;
  int total = 0, scored = 0, failed = 0, unannotated = 0, surfaces = 0, posed = 0;
  std::map<std::string, int> sources;
  for (const FrameRow& row : rows) {
    if (row.method != method || row.dataset != dataset) continue;
    ++total;
    surfaces += row.surfaces;
    posed += row.posed;
    failed += row.status == FrameStatus::method_error;
    collection.harness_errors += row.status == FrameStatus::data_error;
    if (row.score) {
      scored += row.status == FrameStatus::ok;
      ++sources[row.truth_source];
      collection.frames.push_back({*row.score, row.is_sequence ? row.dataset : ""});
    } else {
      unannotated += row.status == FrameStatus::ok;
    }
  }
  Json json;
  json["method"] = method;
  json["dataset"] = dataset;
  json["counts"] = {{"n_total", total},
                    {"n_scored", scored},
                    {"n_method_failed", failed},
                    {"n_harness_error", collection.harness_errors},
                    {"n_not_annotated", unannotated},
                    {"surfaces_found", surfaces},
                    {"surfaces_with_pose", posed}};
  json["truth"] = sources;
  if (!collection.frames.empty()) {
    add_scores(json, collection, groups);
    return json;
  }
  for (const char* part : {"micro", "macro", "errors", "curves", "strata"}) json[part] = nullptr;
  json["reason"] = "no frame has truth";
  return json;
}

std::optional<double> number_from(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() || found->is_null() ? std::nullopt : std::optional(found->get<double>());
}

std::map<std::string, ScoreCell> cells_from(const Json& json) {
  std::map<std::string, ScoreCell> cells;
  if (json.is_null()) return cells;
  for (const auto& [name, value] : json.items())
    cells[name] = {number_from(value, "value"), number_from(value, "lo"), number_from(value, "hi"),
                   number_from(value, "hit"),   number_from(value, "n"),  value.value("reason", "")};
  return cells;
}

ScoreResult result_from(const Json& json) {
  ScoreResult result{json.at("method"), json.at("dataset"), {}, {}, {}, {}, {}, {}};
  json.at("counts").get_to(result.counts);
  json.at("truth").get_to(result.truth_sources);
  result.micro = cells_from(json.at("micro"));
  result.macro = cells_from(json.at("macro"));
  if (json.at("micro").is_null()) return result;
  for (const auto& [name, value] : json.at("errors").items())
    result.errors[name] = {number_from(value, "p50"), number_from(value, "p95"), value.at("n").get<int>()};
  for (const Json& stratum : json.at("strata"))
    result.strata.push_back({stratum.at("axis"), stratum.at("label"), stratum.at("frames"),
                             cells_from(stratum.value("micro", Json(nullptr)))});
  return result;
}

}  // namespace

bool ScoreGroups::contains(std::string_view metric) const {
  if (metric.starts_with("pose_")) return poses;
  if (metric.starts_with("edge_") || metric.starts_with("boundary_")) return edges;
  if (metric.starts_with("object")) return objects;
  return surfaces;
}

std::string metrics_summary_json(const Manifest& manifest, const std::vector<FrameRow>& rows,
                                 const ScoreGroups& groups) {
  Json json;
  json["schema_version"] = Manifest::schema_version;
  json["results"] = Json::array();
  for (const std::string& method : manifest.methods)
    for (const std::string& dataset : manifest.datasets)
      json["results"].push_back(result_of(method, dataset, rows, groups));
  return json.dump(2) + '\n';
}

const ScoreCell& ScoreResult::cell(const std::string& metric) const {
  static const ScoreCell absent{{}, {}, {}, {}, {}, "not scored"};
  const auto found = micro.find(metric);
  return found == micro.end() ? absent : found->second;
}

std::vector<ScoreResult> score_results_from_json(std::string_view text) {
  std::vector<ScoreResult> results;
  try {
    const Json summary = Json::parse(text);
    for (const Json& json : summary.at("results")) results.push_back(result_from(json));
  } catch (const nlohmann::json::exception& e) {
    throw Error(ErrorKind::data, std::string("no summary of metrics: ") + e.what());
  }
  return results;
}

}  // namespace facet
