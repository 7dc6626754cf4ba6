#include "report/run_report.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>

namespace facet {
namespace {

/// Pages with the pictures of every frame would not open on a phone.
constexpr int frames_with_pictures = 6;

ReportSection summary_section(const RunRecord& run) {
  const Manifest& m = run.manifest;
  ReportSection section;
  section.title = "Summary";
  const int failed = m.frames_data_error + m.frames_method_error;
  section.paragraphs.push_back(fmt::format(
      "{}: {} method{} on {}, {} of {} frames processed, {} failed.", status_name(m.status), m.methods.size(),
      m.methods.size() == 1 ? "" : "s", fmt::join(m.datasets, ", "), m.frames_ok, m.frames_planned, failed));
  if (failed > 0)
    section.paragraphs.push_back(fmt::format("Failed: {} could not be read, {} could not be processed.",
                                             m.frames_data_error, m.frames_method_error));
  for (const std::string& note : m.notes) section.paragraphs.push_back(note + '.');
  return section;
}

ReportSection picture_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Pictures";
  section.on_console = false;
  std::map<std::pair<std::string, std::string>, int> shown;
  int left_out = 0;
  for (const FrameRow& row : run.frames) {
    if (row.pictures.empty()) continue;
    if (++shown[{row.dataset, row.method}] > frames_with_pictures) {
      ++left_out;
      continue;
    }
    for (const std::string& file : row.pictures)
      section.pictures.push_back({fmt::format("{} / {} / {}", row.dataset, row.frame, row.method), file});
  }
  if (section.pictures.empty()) section.paragraphs.push_back("no pictures kept");
  if (left_out > 0)
    section.paragraphs.push_back(
        fmt::format("The first {} frames of every data set and method; those of {} more are in "
                    "overlays/.",
                    frames_with_pictures, left_out));
  return section;
}

ReportSection provenance_section(const RunRecord& run) {
  const Manifest& m = run.manifest;
  ReportSection section;
  section.title = "Provenance";
  section.on_console = false;
  ReportTable table;
  table.header = {"what", "value"};
  table.rows = {
      {"experiment", m.experiment},          {"command", fmt::format("{}", fmt::join(m.command, " "))},
      {"configuration hash", m.config_hash}, {"started", m.started_utc},
      {"finished", m.finished_utc},          {"jobs", std::to_string(m.jobs)}};
  for (const auto& [key, value] : run.environment) table.rows.push_back({key, value});
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace

Report make_run_report(const RunRecord& run) {
  Report report;
  report.title = "Facet: " + run.manifest.experiment;
  report.sections = {summary_section(run),      detection_section(run),     timing_section(run),
                     surfaces_section(run),     failures_section(run),      picture_section(run),
                     score_detail_section(run), timing_detail_section(run), provenance_section(run)};
  return report;
}

}  // namespace facet
