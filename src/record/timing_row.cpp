#include "record/timing_row.hpp"

#include <array>
#include <charconv>
#include <fmt/format.h>

#include "core/error.hpp"
#include "record/csv.hpp"

namespace facet {
namespace {

constexpr std::array<std::string_view, 3> phase_names{"first", "warmup", "steady"};
constexpr std::size_t fixed_columns = 8;

template <class T>
T parse_field(const std::string& text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw Error(ErrorKind::data, "timing: '" + text + "' is no number");
  return value;
}

TimingPhase phase_from(const std::string& name) {
  for (std::size_t i = 0; i < phase_names.size(); ++i)
    if (phase_names[i] == name) return static_cast<TimingPhase>(i);
  throw Error(ErrorKind::data, "timing: unknown phase '" + name + "'");
}

std::string milliseconds(double ms) {
  return fmt::format("{:.4f}", ms);
}

void check_width(const CsvRow& row, std::size_t width) {
  if (row.size() != width)
    throw Error(ErrorKind::data, fmt::format("timing: a row of {} fields, expected {}", row.size(), width));
}

}  // namespace

std::string to_csv(const TimingTable& table) {
  CsvRow header{"dataset", "frame", "method", "phase", "repeat", "surfaces", "posed", "total_ms"};
  for (const std::string& stage : table.stages) header.push_back(stage + "_ms");
  std::string text = csv_line(header);
  for (const TimingSample& s : table.samples) {
    CsvRow fields{s.dataset,
                  s.frame,
                  s.method,
                  std::string(phase_names[static_cast<std::size_t>(s.phase)]),
                  std::to_string(s.repeat),
                  std::to_string(s.surfaces),
                  std::to_string(s.posed),
                  milliseconds(s.total_ms)};
    for (std::size_t i = 0; i < table.stages.size(); ++i)
      fields.push_back(s.stage_ms.empty() ? "" : milliseconds(s.stage_ms[i]));
    text += csv_line(fields);
  }
  return text;
}

std::string to_csv(const std::vector<IoTime>& times) {
  std::string text = csv_line({"dataset", "frame", "method", "what", "ms"});
  for (const IoTime& t : times) text += csv_line({t.dataset, t.frame, t.method, t.what, milliseconds(t.ms)});
  return text;
}

TimingTable timing_from_csv(std::string_view text) {
  TimingTable table;
  const std::vector<CsvRow> rows = parse_csv(text);
  if (rows.empty()) return table;
  for (std::size_t i = fixed_columns; i < rows[0].size(); ++i)
    table.stages.push_back(rows[0][i].substr(0, rows[0][i].size() - 3));  // without "_ms"
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const CsvRow& row = rows[r];
    check_width(row, fixed_columns + table.stages.size());
    TimingSample sample{row[0],
                        row[1],
                        row[2],
                        phase_from(row[3]),
                        parse_field<int>(row[4]),
                        parse_field<int>(row[5]),
                        parse_field<int>(row[6]),
                        parse_field<double>(row[7]),
                        {}};
    const bool staged = row.size() > fixed_columns && !row[fixed_columns].empty();
    for (std::size_t i = fixed_columns; staged && i < row.size(); ++i)
      sample.stage_ms.push_back(parse_field<double>(row[i]));
    table.samples.push_back(std::move(sample));
  }
  return table;
}

std::vector<IoTime> io_times_from_csv(std::string_view text) {
  std::vector<IoTime> times;
  const std::vector<CsvRow> rows = parse_csv(text);
  for (std::size_t r = 1; r < rows.size(); ++r) {
    check_width(rows[r], 5);
    times.push_back({rows[r][0], rows[r][1], rows[r][2], rows[r][3], parse_field<double>(rows[r][4])});
  }
  return times;
}

}  // namespace facet
