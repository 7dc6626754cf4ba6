#include "record/sequence_row.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "record/optional_json.hpp"

namespace facet {
namespace {

WindowStart start_from(const std::string& name) {
  const auto found = std::find(window_start_names.begin(), window_start_names.end(), name);
  if (found == window_start_names.end())
    throw Error(ErrorKind::data, "unknown start of a window '" + name + "'");
  return static_cast<WindowStart>(found - window_start_names.begin());
}

/// THE list of keys, those of the planes apart: writing and reading both go through it.
template <class Row, class Visitor>
void visit(Row& row, Visitor&& visit_key) {
  visit_key("timestamp_s", row.timestamp_s);
  visit_key("camera_posed", row.camera_posed);
  visit_key("window_frames", row.window.frames);
  visit_key("window_mean_age_s", row.window.mean_age_s);
  visit_key("compared", row.stability.compared);
  visit_key("in_world", row.stability.in_world);
  visit_key("iou_sum", row.stability.iou_sum);
  visit_key("regions", row.stability.regions);
  visit_key("covered_px", row.stability.covered_px);
  visit_key("region_px", row.stability.region_px);
  visit_key("before", row.stability.before);
  visit_key("kept", row.stability.kept);
}

}  // namespace

nlohmann::ordered_json sequence_to_json(const SequenceRow& row) {
  auto json = nlohmann::ordered_json::object();
  visit(row, [&](const char* key, const auto& value) { json[key] = value; });
  json["window_start"] = std::string(window_start_names[static_cast<std::size_t>(row.window.start)]);
  auto& planes = json["planes"] = nlohmann::ordered_json::array();
  for (const TrackedPlane& p : row.stability.planes)
    planes.push_back({p.track, p.normal.x, p.normal.y, p.normal.z, p.centre_m.x, p.centre_m.y, p.centre_m.z});
  return json;
}

SequenceRow sequence_from_json(const nlohmann::json& json) {
  SequenceRow row;
  visit(row, [&](const char* key, auto& value) { json.at(key).get_to(value); });
  row.window.start = start_from(json.at("window_start").get<std::string>());
  for (const auto& p : json.at("planes"))
    row.stability.planes.push_back({p.at(0).get<int>(),
                                    {p.at(1).get<double>(), p.at(2).get<double>(), p.at(3).get<double>()},
                                    {p.at(4).get<double>(), p.at(5).get<double>(), p.at(6).get<double>()}});
  return row;
}

}  // namespace facet
