#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "report/run_report.hpp"

namespace facet {
namespace {

/// "default, leave_one_out, on D" and its rows in order.
struct AblationTable {
  std::string design, base, dataset;
  std::vector<std::string> switches, measures;
  std::map<std::pair<std::string, std::string>, const AblationRow*> cells;  ///< switch and measure
};

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

std::vector<AblationTable> tables_of(const std::vector<AblationRow>& rows) {
  std::vector<AblationTable> tables;
  for (const AblationRow& row : rows) {
    const auto is_its_own = [&](const AblationTable& t) {
      return t.design == row.design && t.base == row.base && t.dataset == row.dataset;
    };
    auto table = std::find_if(tables.begin(), tables.end(), is_its_own);
    if (table == tables.end()) table = tables.insert(table, {row.design, row.base, row.dataset, {}, {}, {}});
    add_once(table->switches, row.switch_name);
    add_once(table->measures, row.measure);
    table->cells[{row.switch_name, row.measure}] = &row;
  }
  return tables;
}

/// Points for scores, ms for times: "+3.1 [+1.2, +5.0]", with a star where Holm's p is below 0.05.
std::string effect_text(const AblationRow& row) {
  if (!row.change) return "n/a";
  const bool is_time = row.measure == "total_ms";
  const double unit = is_time ? 1 : 100;
  const int digits = is_time ? 2 : 1;
  std::string text = fmt::format("{:+.{}f}", unit * *row.change, digits);
  if (row.lo && row.hi)
    text += fmt::format(" [{:+.{}f}, {:+.{}f}]", unit * *row.lo, digits, unit * *row.hi, digits);
  if (row.p_holm && *row.p_holm < 0.05) text += " *";
  return text;
}

ReportTable effect_table(const AblationTable& in) {
  ReportTable table;
  table.caption =
      fmt::format("What each switch is worth: {} of method {} on {}", in.design, in.base, in.dataset);
  table.full_rows_file = "metrics/ablation.json";
  table.header = {"switch"};
  for (const std::string& measure : in.measures)
    table.header.push_back(measure + (measure == "total_ms" ? " [ms]" : " [points]"));
  std::map<std::string, std::string> reasons;
  for (const std::string& name : in.switches) {
    std::vector<std::string> cells{name};
    for (const std::string& measure : in.measures) {
      const auto cell = in.cells.find({name, measure});
      cells.push_back(cell == in.cells.end() ? "n/a" : effect_text(*cell->second));
      if (cell == in.cells.end() || cell->second->reason.empty()) continue;
      if (!cell->second->change) reasons[name] = cell->second->reason;
    }
    table.rows.push_back(std::move(cells));
  }
  for (const auto& [name, reason] : reasons) table.notes.push_back(fmt::format("{}: n/a, {}.", name, reason));
  table.notes.emplace_back(
      "With the switch less without it, paired per frame, with the 95 % interval; * after Holm's correction "
      "over the "
      "table p < 0.05. The interval of times holds frames, not what the machine did besides.");
  return table;
}

/// Effects with their intervals against zero; nothing where no switch has one.
std::optional<ReportChart> effect_chart(const AblationTable& in, const std::string& measure) {
  const bool is_time = measure == "total_ms";
  const double unit = is_time ? 1 : 100;
  RangeChart chart;
  chart.axis.label = is_time ? "with less without [ms]" : "with less without [points]";
  chart.zero_line = true;
  for (const std::string& name : in.switches) {
    const auto cell = in.cells.find({name, measure});
    if (cell == in.cells.end() || !cell->second->change) continue;
    const AblationRow& row = *cell->second;
    chart.rows.push_back({name,
                          {{0,
                            unit * row.lo.value_or(*row.change),
                            unit * *row.change,
                            unit * row.hi.value_or(*row.change),
                            {},
                            {},
                            name + ": " + effect_text(row)}}});
  }
  if (chart.rows.empty()) return std::nullopt;
  return ReportChart{fmt::format("{}: what each switch is worth, {} on {}", measure, in.base, in.dataset),
                     std::move(chart),
                     {}};
}

}  // namespace

ReportSection ablation_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Ablation";
  for (const AblationTable& table : tables_of(run.ablation)) {
    section.tables.push_back(effect_table(table));
    for (const std::string& measure : table.measures)
      if (auto chart = effect_chart(table, measure)) section.charts.push_back(std::move(*chart));
  }
  if (section.tables.empty()) section.paragraphs.push_back("No switch was turned.");
  return section;
}

}  // namespace facet
