#include "record/frame_row.hpp"

#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tuple>

#include "core/error.hpp"
#include "record/csv.hpp"
#include "record/score_json.hpp"
#include "score/metrics.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::array<std::string_view, 3> status_names{"ok", "data_error", "method_error"};

FrameStatus status_from(const std::string& name) {
  for (std::size_t i = 0; i < status_names.size(); ++i)
    if (status_names[i] == name) return static_cast<FrameStatus>(i);
  throw Error(ErrorKind::data, "unknown frame status '" + name + "'");
}

/// THE list of a row's keys: writing and reading both go through it.
template <class Row, class Visitor>
void visit_row(Row& row, Visitor&& visit) {
  visit("dataset", row.dataset);
  visit("frame", row.frame);
  visit("method", row.method);
  visit("status", row.status);
  visit("is_sequence", row.is_sequence);
  visit("kind", row.kind);
  visit("axis", row.axis);
  visit("level", row.level);
  visit("reason", row.reason);
  visit("config_hash", row.config_hash);
  visit("input_hash", row.input_hash);
  visit("build", row.build);
  visit("width_px", row.width_px);
  visit("height_px", row.height_px);
  visit("missing_px", row.missing_px);
  visit("labelled_px", row.labelled_px);
  visit("depth_edge_px", row.depth_edge_px);
  visit("convex_edge_px", row.convex_edge_px);
  visit("concave_edge_px", row.concave_edge_px);
  visit("surfaces", row.surfaces);
  visit("posed", row.posed);
  visit("curved", row.curved);
  visit("rejected", row.rejected);
  visit("pictures", row.pictures);
  visit("truth_source", row.truth_source);
  visit("score", row.score);
}

/// Keys that rows of earlier versions lack.
template <class Row, class Visitor>
void visit_later_keys(Row& row, Visitor&& visit) {
  visit("sequence", row.sequence);
}

/// The value of a metric in one frame; empty where it has none.
std::string value_text(const FrameRow& row, const Metric& metric) {
  if (!row.score || !metric.is_annotated(*row.score)) return {};
  if (!row.score->failed && !metric.is_predicted(*row.score)) return {};
  const std::optional<double> value = metric.value(metric.sums(*row.score));
  return value ? fmt::format("{:.6g}", *value) : std::string();
}

}  // namespace

std::string_view status_name(FrameStatus status) {
  return status_names[static_cast<std::size_t>(status)];
}

bool row_before(const FrameRow& a, const FrameRow& b) {
  return std::tie(a.dataset, a.frame, a.method) < std::tie(b.dataset, b.frame, b.method);
}

std::string to_json_line(const FrameRow& row) {
  Json json = Json::object();
  const auto write = [&](const char* key, const auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, FrameStatus>)
      json[key] = std::string(status_name(value));
    else if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::optional<FrameScore>>)
      json[key] = value ? Json(score_to_json(*value)) : Json(nullptr);
    else if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::optional<SequenceRow>>)
      json[key] = value ? sequence_to_json(*value) : Json(nullptr);
    else
      json[key] = value;
  };
  visit_row(row, write);
  visit_later_keys(row, write);
  return json.dump() + '\n';
}

FrameRow frame_row_from_json(std::string_view line) {
  FrameRow row;
  try {
    const auto json = nlohmann::json::parse(line);  // the order of members costs time and tells nothing
    visit_row(row, [&](const char* key, auto& value) {
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, FrameStatus>)
        value = status_from(json.at(key).get<std::string>());
      else if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::optional<FrameScore>>) {
        if (!json.at(key).is_null()) value = score_from_json(json.at(key));
      } else
        json.at(key).get_to(value);
    });
    visit_later_keys(row, [&](const char* key, std::optional<SequenceRow>& value) {
      if (json.contains(key) && !json.at(key).is_null()) value = sequence_from_json(json.at(key));
    });
  } catch (const nlohmann::json::exception& e) {
    throw Error(ErrorKind::data, std::string("not a frame row: ") + e.what());
  }
  return row;
}

std::string frames_csv(const std::vector<FrameRow>& rows) {
  CsvRow header({"dataset", "frame", "method", "status", "reason", "width_px", "height_px", "missing_px",
                 "labelled_px", "depth_edge_px", "convex_edge_px", "concave_edge_px", "surfaces", "posed",
                 "curved", "rejected", "truth_source"});
  for (const Metric& metric : score_metrics()) header.push_back(metric.name);
  std::string text = csv_line(header);
  for (const FrameRow& r : rows) {
    int rejected = 0;
    for (const auto& [reason, count] : r.rejected) rejected += count;
    CsvRow fields{r.dataset, r.frame, r.method, std::string(status_name(r.status)), r.reason};
    const bool ok = r.status == FrameStatus::ok;  // a failed frame has no counts, which is not the same as 0
    for (const std::int64_t count :
         {std::int64_t{r.width_px}, std::int64_t{r.height_px}, r.missing_px, r.labelled_px, r.depth_edge_px,
          r.convex_edge_px, r.concave_edge_px, std::int64_t{r.surfaces}, std::int64_t{r.posed},
          std::int64_t{r.curved}, std::int64_t{rejected}})
      fields.push_back(ok ? std::to_string(count) : "");
    fields.push_back(r.truth_source);
    for (const Metric& metric : score_metrics()) fields.push_back(value_text(r, metric));
    text += csv_line(fields);
  }
  return text;
}

}  // namespace facet
