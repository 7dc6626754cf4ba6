#include "report/run_report.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>

namespace facet {
namespace {

/// Pages with the pictures of every frame would not open on a phone.
constexpr std::size_t pictures_on_page = 12;

/// How many frames of every data set and method have room.
std::size_t room_for_each(const RunRecord& run) {
  const std::size_t groups = run.manifest.datasets.size() * run.manifest.methods.size();
  return std::clamp<std::size_t>(pictures_on_page / std::max<std::size_t>(groups, 1), 1, 6);
}

/// The gallery, or the worst of the frames, or the first with pictures where there is no truth.
std::vector<GalleryEntry> frames_to_show(const RunRecord& run) {
  if (!run.gallery.empty()) return run.gallery;
  std::vector<GalleryEntry> entries = worst_frames(run.frames, "surface_f1_0.5", room_for_each(run));
  std::erase_if(entries, [](const GalleryEntry& e) { return e.picture.empty(); });
  if (!entries.empty()) return entries;
  std::map<std::pair<std::string, std::string>, std::size_t> shown;
  for (const FrameRow& row : run.frames)
    if (!row.pictures.empty() && ++shown[{row.dataset, row.method}] <= room_for_each(run))
      entries.push_back({row.dataset, row.frame, row.method, {}, {}, {}, row.pictures.front()});
  return entries;
}

ReportSection picture_section(const RunRecord& run) {
  const std::vector<GalleryEntry> entries = frames_to_show(run);
  ReportSection section;
  section.title = "Pictures";
  section.on_console = false;
  if (entries.empty()) section.paragraphs.push_back("no pictures kept");
  const bool rated = !entries.empty() && entries.front().value;
  if (rated) {
    section.title = "Worst frames";
    section.paragraphs.push_back(
        fmt::format("The worst frames of every method and data set by {}; `facet gallery` draws others.",
                    entries.front().metric));
  }
  for (const GalleryEntry& e : entries) {
    std::string caption = fmt::format("{} / {} / {}", e.dataset, e.frame, e.method);
    if (e.value) caption += fmt::format(": {} = {:.3f}", e.metric, *e.value);
    section.pictures.push_back({std::move(caption), e.picture});
  }
  return section;
}

ReportSection provenance_section(const RunRecord& run) {
  const Manifest& m = run.manifest;
  ReportSection section;
  section.title = "Provenance";
  section.on_console = false;
  ReportTable table;
  section.folded = true;
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
  report.sections = {summary_section(run),      detection_section(run),     methods_section(run),
                     disputed_section(run),     sequence_section(run),      timing_section(run),
                     clutter_section(run),      curve_section(run),         level_section(run),
                     surfaces_section(run),     failures_section(run),      picture_section(run),
                     score_detail_section(run), timing_detail_section(run), provenance_section(run)};
  std::erase_if(report.sections, [](const ReportSection& section) {
    return section.paragraphs.empty() && section.tables.empty() && section.pictures.empty();
  });
  if (!run.ablation.empty()) report.sections.insert(report.sections.begin() + 1, ablation_section(run));
  if (!run.sweep.empty()) report.sections.insert(report.sections.begin() + 1, sweep_section(run));
  return report;
}

}  // namespace facet
