#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "report/run_report.hpp"

namespace facet {
namespace {

using FrameKey = std::pair<std::string, std::string>;  // data set, frame

ReportTable surfaces_of(const RunRecord& run, const std::string& dataset) {
  ReportTable table;
  table.caption = fmt::format("Surfaces found on {}", dataset);
  table.header = {"frame"};
  table.full_rows_file = "metrics/frames.csv";
  std::map<std::string, std::map<std::string, const FrameRow*>> frames;
  for (const FrameRow& row : run.frames)
    if (row.dataset == dataset) frames[row.frame][row.method] = &row;
  for (const std::string& method : run.manifest.methods) table.header.push_back(method);
  for (const auto& [frame, methods] : frames) {
    std::vector<std::string> cells{frame};
    for (const std::string& method : run.manifest.methods) {
      const auto found = methods.find(method);
      if (found == methods.end())
        cells.push_back("not run");
      else if (found->second->status != FrameStatus::ok)
        cells.push_back("failed");
      else
        cells.push_back(std::to_string(found->second->surfaces));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string empty_reason_note(const FrameRow& row) {
  return fmt::format("{}, {}: no surface: {}", row.frame, row.method, row.reason);
}

}  // namespace

ReportSection surfaces_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Surfaces";
  section.folded = true;
  for (const std::string& dataset : run.manifest.datasets) {
    ReportTable table = surfaces_of(run, dataset);
    for (const FrameRow& row : run.frames)
      if (row.dataset == dataset && row.status == FrameStatus::ok && row.surfaces == 0 && !row.reason.empty())
        table.notes.push_back(empty_reason_note(row));
    if (!table.rows.empty()) section.tables.push_back(std::move(table));
  }
  if (section.tables.empty()) section.paragraphs.push_back("No frame was processed.");
  return section;
}

ReportSection failures_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Failed frames";
  ReportTable table;
  table.header = {"frame", "method", "kind", "reason"};
  table.full_rows_file = "frames.jsonl";
  for (const FrameRow& row : run.frames)
    if (row.status != FrameStatus::ok)
      table.rows.push_back(
          {row.dataset + '/' + row.frame, row.method, std::string(status_name(row.status)), row.reason});
  if (table.rows.empty())
    section.paragraphs.push_back("None.");
  else
    section.tables.push_back(std::move(table));
  return section;
}

}  // namespace facet
