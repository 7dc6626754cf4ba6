#include "record/sweep_row.hpp"

#include "core/error.hpp"
#include "record/optional_json.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;

/// THE list of a row's keys.
template <class Row, class Visitor>
void visit_row(Row& row, Visitor&& visit) {
  visit("method", row.method);
  visit("base", row.base);
  visit("settings", row.settings);
  visit("dataset", row.dataset);
  visit("axis", row.axis);
  visit("level", row.level);
  visit("measure", row.measure);
  visit("value", row.value);
  visit("lo", row.lo);
  visit("hi", row.hi);
  visit("reason", row.reason);
}

}  // namespace

std::string sweep_to_json(const std::vector<SweepRow>& rows) {
  Json list = Json::array();
  for (const SweepRow& row : rows) {
    Json json;
    visit_row(row, [&](const char* key, const auto& value) { json[key] = value; });
    list.push_back(std::move(json));
  }
  return Json{{"schema_version", 1}, {"rows", list}}.dump(1) + '\n';
}

std::vector<SweepRow> sweep_from_json(std::string_view text) {
  std::vector<SweepRow> rows;
  try {
    const Json document = Json::parse(text);
    for (const Json& json : document.at("rows")) {
      SweepRow row;
      visit_row(row, [&](const char* key, auto& value) { json.at(key).get_to(value); });
      rows.push_back(std::move(row));
    }
  } catch (const nlohmann::json::exception& e) {
    throw Error(ErrorKind::data, std::string("no sweep rows: ") + e.what());
  }
  return rows;
}

}  // namespace facet
