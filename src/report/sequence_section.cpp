#include <algorithm>
#include <fmt/format.h>

#include "record/sequence_summary.hpp"
#include "report/run_report.hpp"
#include "score/intervals.hpp"

namespace facet {
namespace {

using Summaries = std::vector<SequenceSummary>;

std::string number(const std::optional<double>& value, double factor, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value * factor) : "n/a";
}

/// A table with a column for every method.
class MethodTable {
 public:
  MethodTable(std::string caption, const Summaries& summaries) : summaries_(summaries) {
    table_.caption = std::move(caption);
    table_.header = {"what"};
    for (const SequenceSummary& s : summaries) table_.header.push_back(s.method);
  }
  template <class Text>
  void row(const char* what, const Text& text) {
    std::vector<std::string> cells{what};
    for (const SequenceSummary& s : summaries_) cells.push_back(text(s));
    table_.rows.push_back(std::move(cells));
  }
  void note(std::string text) { table_.notes.push_back(std::move(text)); }
  ReportTable take() { return std::move(table_); }

 private:
  const Summaries& summaries_;
  ReportTable table_;
};

ReportTable window_table(const std::string& dataset, const Summaries& summaries) {
  MethodTable table(fmt::format("Frames averaged on {}", dataset), summaries);
  const auto starts = [](const char* reason) {
    return [reason](const SequenceSummary& s) {
      const auto found = s.starts.find(reason);
      return std::to_string(found == s.starts.end() ? 0 : found->second);
    };
  };
  table.row("Frames processed", [](const auto& s) { return std::to_string(s.frames); });
  table.row("  with truth", [](const auto& s) { return std::to_string(s.with_truth); });
  table.row("  with a time", [](const auto& s) { return std::to_string(s.with_time); });
  table.row("  with a pose of the camera", [](const auto& s) { return std::to_string(s.with_pose); });
  table.row("Duration [s]", [](const auto& s) { return number(s.duration_s, 1, "{:.2f}"); });
  table.row("Frames averaged, mean", [](const auto& s) { return number(s.window_frames, 1, "{:.2f}"); });
  table.row("Windows ended by motion of the camera", starts("motion"));
  table.row("Windows ended by a gap in time", starts("gap"));
  table.row("Age of the averaged readings [ms], mean",
            [](const auto& s) { return number(s.mean_age_s, 1000, "{:.1f}"); });
  table.row("  most", [](const auto& s) { return number(s.most_age_s, 1000, "{:.1f}"); });
  table.note(
      "The age is what averaging adds to the latency: the frames are that old on average, the current one "
      "included.");
  return table.take();
}

std::string kept_text(const SequenceSummary& s) {
  if (s.before == 0) return "n/a";
  const double before = static_cast<double>(s.before), kept = static_cast<double>(s.kept);
  const Interval interval = wilson_interval(kept, before);
  return fmt::format("{}/{} {:.1f} % [{:.1f}, {:.1f}]", s.kept, s.before, 100 * kept / before,
                     100 * interval.lo, 100 * interval.hi);
}

std::string spread_text(const Spread& spread) {
  if (!spread.p50 || !spread.p95) return "n/a";
  return fmt::format("{:.3g}, {:.3g}, n = {}", *spread.p50, *spread.p95, spread.n);
}

ReportTable stability_table(const std::string& dataset, const Summaries& summaries) {
  MethodTable table(fmt::format("Stability from frame to frame on {}, without truth", dataset), summaries);
  table.row("Pairs of frames compared", [](const auto& s) { return std::to_string(s.compared); });
  table.row("  where the camera's motion is known", [](const auto& s) { return std::to_string(s.in_world); });
  table.row("Overlap of regions, mean IoU [%]",
            [](const auto& s) { return number(s.region_iou, 100, "{:.1f}"); });
  table.row("  weighed by pixels [%]", [](const auto& s) { return number(s.covering, 100, "{:.1f}"); });
  table.row("Regions found again", kept_text);
  table.row("Mean life of a region [s]", [](const auto& s) { return number(s.life_s, 1, "{:.2f}"); });
  table.row("Jitter of normals [deg]: median, 95 %",
            [](const auto& s) { return spread_text(s.normal_jitter_deg); });
  table.row("Jitter of centres [mm]: median, 95 %",
            [](const auto& s) { return spread_text(s.centre_jitter_mm); });
  const bool unknown = std::any_of(summaries.begin(), summaries.end(),
                                   [](const SequenceSummary& s) { return s.in_world < s.compared; });
  if (unknown)
    table.note(
        "Where the pose of the camera is not known, frames are compared as they are: its motion counts as "
        "change and as jitter.");
  return table.take();
}

}  // namespace

ReportSection sequence_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Sequences";
  const Summaries all = summarize_sequences(run.frames);
  for (const std::string& dataset : run.manifest.datasets) {
    Summaries summaries;
    for (const std::string& method : run.manifest.methods)
      for (const SequenceSummary& s : all)
        if (s.dataset == dataset && s.method == method) summaries.push_back(s);
    if (summaries.empty()) continue;
    section.tables.push_back(window_table(dataset, summaries));
    section.tables.push_back(stability_table(dataset, summaries));
  }
  return section;
}

}  // namespace facet
