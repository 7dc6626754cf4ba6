#include "compare/comparison_report.hpp"

#include <array>
#include <fmt/format.h>
#include <map>

namespace facet {
namespace {

bool is_unremarkable(const ComparedValue& value) {
  return value.verdict == Verdict::ok || (!value.before && !value.vanished);
}

std::string number(const ComparedValue& value, const std::optional<double>& v) {
  if (!v) return "n/a";
  return value.kind == MeasuredKind::latency ? fmt::format("{:.3f} ms", *v) : fmt::format("{:.4f}", *v);
}

std::string change_text(const ComparedValue& value) {
  if (!value.change) return "n/a";
  std::string text = fmt::format("{:+.4f}", *value.change);
  if (value.interval) text += fmt::format(" [{:+.4f}, {:+.4f}]", value.interval->lo, value.interval->hi);
  return text;
}

ReportTable values_table(const Comparison& comparison, const std::string& caption, bool all) {
  ReportTable table;
  table.caption = caption;
  table.header = {"value", "method", "data set", "before", "after", "change [95 %]", "p", "n", "verdict"};
  for (const ComparedValue& value : comparison.values) {
    if (!all && is_unremarkable(value)) continue;
    table.rows.push_back({value.name, value.method, value.dataset, number(value, value.before),
                          number(value, value.after), change_text(value),
                          value.p ? fmt::format("{:.4f}", *value.p) : "n/a", std::to_string(value.n),
                          fmt::format("{}{}{}", value.vanished ? "vanished" : verdict_name(value.verdict),
                                      value.reason.empty() ? "" : ": ", value.reason)});
  }
  return table;
}

std::string counts_text(const Comparison& comparison) {
  std::map<Verdict, int> counts;
  for (const ComparedValue& value : comparison.values) ++counts[value.verdict];
  std::string text;
  for (const auto& [verdict, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, verdict_name(verdict));
  return text.empty() ? "no value" : text;
}

constexpr std::array<const char*, 3> result_names{"passed", "failed", "not measured"};

}  // namespace

Report make_comparison_report(const Comparison& comparison, const GateDecision& decision,
                              const ComparedNames& names) {
  Report report;
  report.title = fmt::format("{} against {}", names.after, names.before);
  ReportSection summary;
  summary.title = fmt::format("Comparison: {}", result_names[static_cast<std::size_t>(decision.result)]);
  summary.paragraphs.push_back(counts_text(comparison) + '.');
  for (const std::string& failure : decision.failures) summary.paragraphs.push_back(failure + '.');
  for (const std::string& note : comparison.notes) summary.paragraphs.push_back(note + '.');
  ReportTable remarkable = values_table(comparison, "What is not ok, or has improved", false);
  remarkable.notes.emplace_back(
      "Change: after - before, with its 95 % interval from paired resampling of frames. Times are lower "
      "quartiles "
      "of a frame's repeats, over the calibration block, in ms of the machine before.");
  remarkable.notes.emplace_back(
      "How times differ between runs of one build is in the interval only where both were run in rounds.");
  if (!remarkable.rows.empty()) summary.tables.push_back(std::move(remarkable));
  report.sections.push_back(std::move(summary));
  ReportSection all;
  all.title = "Every value";
  all.on_console = false;
  all.tables.push_back(values_table(comparison, "Every value", true));
  report.sections.push_back(std::move(all));
  return report;
}

std::string github_annotations(const GateDecision& decision) {
  // A line break ends a command, and '%' starts an escape.
  const auto escaped = [](const std::string& text) {
    std::string out;
    for (const char c : text)
      out += c == '%' ? "%25" : c == '\n' ? "%0A" : c == '\r' ? "%0D" : std::string(1, c);
    return out;
  };
  std::string text;
  for (const std::string& failure : decision.failures)
    text += fmt::format("::error title=facet gate::{}\n", escaped(failure));
  for (const std::string& warning : decision.warnings)
    text += fmt::format("::warning title=facet gate::{}\n", escaped(warning));
  return text;
}

}  // namespace facet
