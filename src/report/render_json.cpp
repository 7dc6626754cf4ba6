#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "report/document.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;

Json bound(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json body_json(const XyChart& chart) {
  Json json{{"x", chart.x.label}, {"y", chart.y.label}, {"series", Json::array()}};
  for (const ChartSeries& series : chart.series) {
    Json points = Json::array();
    for (const ChartPoint& p : series.points)
      points.push_back({{"x", p.x}, {"y", p.y}, {"lo", bound(p.lo)}, {"hi", bound(p.hi)}, {"what", p.hover}});
    json["series"].push_back({{"name", series.name}, {"points", points}});
  }
  return json;
}

Json body_json(const RangeChart& chart) {
  Json json{{"x", chart.axis.label}, {"rows", Json::array()}};
  for (const RangeChart::Row& row : chart.rows)
    for (const ChartRange& r : row.ranges)
      json["rows"].push_back(
          {{"row", row.label},
           {"series",
            chart.legend.empty() ? std::string() : chart.legend.at(static_cast<std::size_t>(r.color))},
           {"low", r.low},
           {"box_low", bound(r.box_low)},
           {"middle", r.middle},
           {"box_high", bound(r.box_high)},
           {"high", r.high}});
  return json;
}

Json table_json(const ReportTable& table) {
  return {{"caption", table.caption}, {"header", table.header}, {"rows", table.rows}, {"notes", table.notes}};
}

Json section_json(const ReportSection& section) {
  Json json{{"title", section.title}, {"paragraphs", section.paragraphs}};
  for (const char* part : {"tables", "charts", "pictures"}) json[part] = Json::array();
  for (const ReportTable& table : section.tables) json["tables"].push_back(table_json(table));
  for (const ReportChart& chart : section.charts) {
    Json entry{{"title", chart.title}, {"notes", chart.notes}};
    entry.update(std::visit([](const auto& body) { return body_json(body); }, chart.body));
    json["charts"].push_back(std::move(entry));
  }
  for (const ReportPicture& picture : section.pictures)
    json["pictures"].push_back({{"caption", picture.caption}, {"file", picture.file.generic_string()}});
  return json;
}

ReportTable table_from(const Json& json) {
  ReportTable table;
  json.at("caption").get_to(table.caption);
  json.at("header").get_to(table.header);
  json.at("rows").get_to(table.rows);
  json.at("notes").get_to(table.notes);
  return table;
}

ReportSection section_from(const Json& json) {
  ReportSection section;
  json.at("title").get_to(section.title);
  json.at("paragraphs").get_to(section.paragraphs);
  for (const Json& table : json.at("tables")) section.tables.push_back(table_from(table));
  for (const Json& picture : json.at("pictures"))
    section.pictures.push_back({picture.at("caption"), picture.at("file").get<std::string>()});
  return section;
}

}  // namespace

Report report_from_json(const std::string& text, const std::string& source) {
  try {
    const Json json = Json::parse(text);
    Report report;
    json.at("title").get_to(report.title);
    for (const Json& section : json.at("sections")) report.sections.push_back(section_from(section));
    return report;
  } catch (const Json::exception& e) {
    throw Error(ErrorKind::data, source + ": is no report: " + e.what());
  }
}

std::string render_json(const Report& report) {
  Json json{{"schema_version", 1}, {"title", report.title}, {"sections", Json::array()}};
  for (const ReportSection& section : report.sections) json["sections"].push_back(section_json(section));
  return json.dump(1) + '\n';
}

}  // namespace facet
