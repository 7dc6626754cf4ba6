#include "record/metrics_summary.hpp"

#include <nlohmann/json.hpp>

namespace facet {
namespace {

using Json = nlohmann::ordered_json;

Json summarize(const std::string& method, const std::string& dataset, const std::vector<FrameRow>& rows) {
  int total = 0, data_errors = 0, method_errors = 0, surfaces = 0, posed = 0;
  for (const FrameRow& row : rows) {
    if (row.method != method || row.dataset != dataset) continue;
    ++total;
    data_errors += row.status == FrameStatus::data_error;
    method_errors += row.status == FrameStatus::method_error;
    surfaces += row.surfaces;
    posed += row.posed;
  }
  Json json;
  json["method"] = method;
  json["dataset"] = dataset;
  json["micro"] = nullptr;
  json["macro"] = nullptr;
  json["strata"] = nullptr;
  json["reason"] = "not scored: no scorer in this version";
  json["counts"] = {{"n_total", total},
                    {"n_scored", 0},
                    {"n_method_failed", method_errors},
                    {"n_harness_error", data_errors},
                    {"surfaces_found", surfaces},
                    {"surfaces_with_pose", posed}};
  return json;
}

}  // namespace

std::string metrics_summary_json(const Manifest& manifest, const std::vector<FrameRow>& rows) {
  Json json;
  json["schema_version"] = Manifest::schema_version;
  json["results"] = Json::array();
  for (const std::string& method : manifest.methods)
    for (const std::string& dataset : manifest.datasets)
      json["results"].push_back(summarize(method, dataset, rows));
  return json.dump(2) + '\n';
}

}  // namespace facet
