#include "stream/stream_report.hpp"

#include <fmt/format.h>

#include "stream/stream_summary.hpp"

namespace facet {
namespace {

std::string percentile_cell(const TimeStatistics& t, std::size_t i) {
  if (t.percentile_ms[i]) return fmt::format("{:.2f}", *t.percentile_ms[i]);
  return fmt::format("n/a (n = {} < {})", t.n, least_samples_for(percentiles[i]));
}

std::string number_cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.2f}", *value) : "n/a";
}

std::vector<std::string> time_cells(const TimeStatistics& t) {
  std::vector<std::string> cells{std::to_string(t.n)};
  if (t.n == 0) return {"0", "n/a", "n/a", "n/a", "n/a", "n/a", "n/a", "n/a"};
  cells.push_back(fmt::format("{:.2f}", t.mean_ms));
  for (const std::size_t i : {0, 1, 3}) cells.push_back(percentile_cell(t, i));
  cells.push_back(fmt::format("{:.2f}", t.max_ms));
  for (const int misses : t.deadline_misses) cells.push_back(std::to_string(misses));
  return cells;
}

ReportTable time_table(const std::string& caption, const std::vector<StreamTimes>& rows) {
  ReportTable table;
  table.caption = caption;
  table.header = {"", "frames", "mean", "p50", "p90", "p99", "max"};
  for (const double deadline : deadlines_ms) table.header.push_back(fmt::format("over {:.1f} ms", deadline));
  for (const StreamTimes& times : rows) {
    table.rows.push_back({times.name});
    for (std::string& cell : time_cells(times.wall)) table.rows.back().push_back(std::move(cell));
  }
  return table;
}

ReportTable way_table(const StreamSummary& summary) {
  std::vector<StreamTimes> rows = summary.filters;
  rows.push_back(summary.pass);
  rows.push_back(summary.latency);
  ReportTable table = time_table("Filters and the way through them, wall time [ms]", rows);
  table.header.insert(table.header.end(), {"threads", "CPU mean"});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    table.rows[i].push_back(rows[i].threads > 0 ? std::to_string(rows[i].threads) : "");
    table.rows[i].push_back(rows[i].cpu_mean_ms ? fmt::format("{:.2f}", *rows[i].cpu_mean_ms) : "");
  }
  table.notes = {"pass: from the first filter's start to the result, queues between filters included.",
                 "end to end: from when the frame was due (as fast as possible: from when it was offered) to "
                 "the result, waiting included."};
  return table;
}

ReportTable queue_table(const StreamRecord& record) {
  ReportTable table;
  table.caption = "Queues [frames]";
  table.header = {"before", "room", "mean depth", "max depth", "taken in", "dropped"};
  for (std::size_t i = 0; i < record.queues.size(); ++i) {
    const QueueStatistics& q = record.queues[i];
    const bool is_last = i == record.options.filters.size();
    table.rows.push_back({is_last ? "the end" : record.options.filters[i].name, std::to_string(q.capacity),
                          fmt::format("{:.2f}", q.mean_depth), std::to_string(q.max_depth),
                          std::to_string(q.taken_in), std::to_string(q.dropped)});
  }
  return table;
}

ReportTable run_table(const StreamRecord& r, const StreamSummary& summary) {
  const MemoryUse& m = r.memory;
  ReportTable table;
  table.header = {"what", "value"};
  table.rows = {{"frames due", std::to_string(r.due)},
                {"frames offered", std::to_string(r.offered)},
                {"frames processed", std::to_string(r.samples.size())},
                {"frames dropped", std::to_string(r.dropped())},
                {"frames accepted late", std::to_string(r.late)},
                {"frames per second", fmt::format("{:.2f}", summary.throughput_hz)},
                {"memory after warm-up, MB", fmt::format("{:.1f}", m.after_warmup_mb)},
                {"memory at the end, MB", fmt::format("{:.1f}", m.end_mb)},
                {"most memory, MB", fmt::format("{:.1f}", m.max_mb)},
                {"processor time per frame, ms", number_cell(summary.cpu_per_frame_ms)},
                {fmt::format("frames per second that {} cores could do by that", r.load.cores),
                 number_cell(summary.most_hz)},
                {"cores used by this program", fmt::format("{:.2f}", r.load.own_cores)},
                {"cores used by others meanwhile", fmt::format("{:.2f}", r.load.other_cores)}};
  table.notes.push_back(fmt::format(
      "{} frames in memory, taken in turn; the first {} are warm-up; {} thread{} inside a frame.",
      r.frames_in_memory, r.options.warmup, r.threads_in_frame, r.threads_in_frame == 1 ? "" : "s"));
  return table;
}

std::string offered_text(const StreamOptions& options) {
  switch (options.pace) {
    case StreamPace::fixed:
      return fmt::format("{:g} frames/s offered", options.rate_hz);
    case StreamPace::recorded:
      return "frames offered at the recorded times";
    default:
      return "frames offered as fast as they are taken";
  }
}

std::string verdict(const StreamRecord& record, const StreamSummary& summary) {
  std::string text =
      fmt::format("{}, {:.2f} frames/s processed", offered_text(record.options), summary.throughput_hz);
  if (!summary.is_sustained) return text + ".";
  text += *summary.is_sustained ? ": sustained" : ": NOT sustained";
  return text + fmt::format(
                    "; of {} frames due {} were never offered for want of room, {} accepted only when the "
                    "next was due, {} dropped.",
                    record.due, record.due - record.offered, record.late, record.dropped());
}

/// The paper's own limit, of section 4.1.2.
std::string paper_verdict(const StreamSummary& summary) {
  const auto part = [](const StreamTimes& times) {
    const TimeStatistics& t = times.wall;
    return fmt::format("{} {}", times.name,
                       t.deadline_misses[0] == 0
                           ? "within it"
                           : fmt::format("over it in {} of {}", t.deadline_misses[0], t.n));
  };
  if (summary.pass.wall.n == 0) return "No frame was processed after warm-up.";
  std::string text =
      fmt::format("The paper asks for {:.1f} ms in every filter and in the pass: ", deadlines_ms[0]);
  for (const StreamTimes& filter : summary.filters) text += part(filter) + ", ";
  return text + part(summary.pass) + ".";
}

ReportSection stream_section(const StreamRecord& record) {
  const StreamSummary summary = summarize(record);
  ReportSection section;
  section.title = fmt::format("{} on {}", record.method, record.dataset);
  if (record.interrupted) section.paragraphs.push_back("Interrupted: what was measured until then.");
  section.paragraphs.push_back(verdict(record, summary));
  section.paragraphs.push_back(paper_verdict(summary));
  section.tables = {way_table(summary), time_table("Stages, wall time [ms]", summary.stages),
                    queue_table(record), run_table(record, summary)};
  return section;
}

}  // namespace

Report make_stream_report(const std::string& experiment, const std::vector<StreamRecord>& records) {
  Report report;
  report.title = "Facet: stream " + experiment;
  for (const StreamRecord& record : records) report.sections.push_back(stream_section(record));
  return report;
}

}  // namespace facet
