#include "record/ablation_row.hpp"

#include "core/error.hpp"
#include "record/optional_json.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;

/// THE list of a row's keys.
template <class Row, class Visitor>
void visit_row(Row& row, Visitor&& visit) {
  visit("design", row.design);
  visit("base", row.base);
  visit("switch", row.switch_name);
  visit("dataset", row.dataset);
  visit("measure", row.measure);
  visit("with", row.with);
  visit("without", row.without);
  visit("change", row.change);
  visit("lo", row.lo);
  visit("hi", row.hi);
  visit("p", row.p);
  visit("p_holm", row.p_holm);
  visit("n", row.n);
  visit("reason", row.reason);
}

}  // namespace

std::string ablation_to_json(const std::vector<AblationRow>& rows) {
  Json list = Json::array();
  for (const AblationRow& row : rows) {
    Json json;
    visit_row(row, [&](const char* key, const auto& value) { json[key] = value; });
    list.push_back(std::move(json));
  }
  return Json{{"schema_version", 1}, {"rows", list}}.dump(1) + '\n';
}

std::vector<AblationRow> ablation_from_json(std::string_view text) {
  std::vector<AblationRow> rows;
  try {
    const Json document = Json::parse(text);
    for (const Json& json : document.at("rows")) {
      AblationRow row;
      visit_row(row, [&](const char* key, auto& value) { json.at(key).get_to(value); });
      rows.push_back(std::move(row));
    }
  } catch (const nlohmann::json::exception& e) {
    throw Error(ErrorKind::data, std::string("no ablation rows: ") + e.what());
  }
  return rows;
}

}  // namespace facet
