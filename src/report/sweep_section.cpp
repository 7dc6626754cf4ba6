#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <map>

#include "report/run_report.hpp"

namespace facet {
namespace {

/// One base on one data set: points in their order, a column per measure.
struct SweepTable {
  std::string base, dataset;
  std::vector<const SweepRow*> points;  ///< the first row of each method
  std::vector<std::string> measures;
  std::map<std::pair<std::string, std::string>, const SweepRow*> cells;  ///< method and measure
};

std::vector<SweepTable> tables_of(const std::vector<SweepRow>& rows) {
  std::vector<SweepTable> tables;
  for (const SweepRow& row : rows) {
    if (!row.axis.empty()) continue;  // curves over what a data set varies are a section of their own
    auto table = std::find_if(tables.begin(), tables.end(),
                              [&](const auto& t) { return t.base == row.base && t.dataset == row.dataset; });
    if (table == tables.end()) table = tables.insert(table, {row.base, row.dataset, {}, {}, {}});
    if (std::none_of(table->points.begin(), table->points.end(),
                     [&](const SweepRow* p) { return p->method == row.method; }))
      table->points.push_back(&row);
    if (std::find(table->measures.begin(), table->measures.end(), row.measure) == table->measures.end())
      table->measures.push_back(row.measure);
    table->cells[{row.method, row.measure}] = &row;
  }
  return tables;
}

double unit_of(const std::string& measure) {
  return measure == "total_ms" ? 1 : 100;
}

std::string label_of(const std::string& measure) {
  return measure + (measure == "total_ms" ? " [ms]" : " [%]");
}

std::string cell_text(const SweepRow& row) {
  if (!row.value) return "n/a";
  const double unit = unit_of(row.measure);
  std::string text = fmt::format("{:.1f}", unit * *row.value);
  if (row.lo && row.hi) text += fmt::format(" [{:.1f}, {:.1f}]", unit * *row.lo, unit * *row.hi);
  return text;
}

ReportTable point_table(const SweepTable& in) {
  ReportTable table;
  table.caption = fmt::format("Sweep of method {} on {}", in.base, in.dataset);
  table.full_rows_file = "metrics/sweep.json";
  for (const auto& [parameter, unused] : in.points.front()->settings) table.header.push_back(parameter);
  for (const std::string& measure : in.measures) table.header.push_back(label_of(measure));
  for (const SweepRow* point : in.points) {
    std::vector<std::string> cells;
    for (const auto& [parameter, value] : point->settings) cells.push_back(value);
    for (const std::string& measure : in.measures) {
      const auto cell = in.cells.find({point->method, measure});
      cells.push_back(cell == in.cells.end() ? "n/a" : cell_text(*cell->second));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::optional<double> number_of(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// A curve per measure, where one parameter was swept over numbers.
void add_charts(const SweepTable& in, ReportSection& section) {
  if (in.points.front()->settings.size() != 1) return;
  const std::string& parameter = in.points.front()->settings.begin()->first;
  for (const std::string& measure : in.measures) {
    ChartSeries series{in.base, 0, true, true, {}};
    for (const SweepRow* point : in.points) {
      const auto cell = in.cells.find({point->method, measure});
      const auto x = number_of(point->settings.begin()->second);
      if (!x || cell == in.cells.end() || !cell->second->value) continue;
      const SweepRow& row = *cell->second;
      const double unit = unit_of(measure);
      const auto scaled = [&](const std::optional<double>& v) { return v ? std::optional(unit * *v) : v; };
      series.points.push_back({*x, unit * *row.value, scaled(row.lo), scaled(row.hi),
                               fmt::format("{} = {}: {}", parameter, *x, cell_text(row))});
    }
    if (series.points.size() < 2) continue;
    XyChart body{{parameter, {}, {}}, {label_of(measure), {}, {}}, {std::move(series)}};
    section.charts.push_back(
        {fmt::format("{} over {}, {}", measure, parameter, in.dataset), std::move(body), {}});
  }
}

}  // namespace

ReportSection sweep_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Sweep";
  for (const SweepTable& table : tables_of(run.sweep)) {
    section.tables.push_back(point_table(table));
    add_charts(table, section);
  }
  return section;
}

}  // namespace facet
