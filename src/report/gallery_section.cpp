#include "report/gallery_section.hpp"

#include <fmt/format.h>

namespace facet {
namespace {

/// What finds exactly that text as a regular expression inside single quotes of a shell.
std::string literal_pattern(const std::string& text) {
  std::string pattern;
  for (const char c : text) {
    if (std::string_view("\\^$.|?*+()[]{}").find(c) != std::string_view::npos) pattern += '\\';
    pattern += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return pattern;
}

std::string value_text(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "n/a";
}

}  // namespace

ReportSection gallery_section(const std::vector<GalleryEntry>& entries, const std::string& command) {
  ReportSection section;
  section.title = "Worst frames";
  ReportTable table;
  table.header = {"frame", "method", "score", "value"};
  const bool compared = !entries.empty() && entries.front().baseline;
  if (compared) table.header.emplace_back("before");
  table.header.emplace_back("run it again");
  for (const GalleryEntry& e : entries) {
    std::vector<std::string> row{e.dataset + '/' + e.frame, e.method, e.metric, value_text(e.value)};
    std::string caption =
        fmt::format("{} / {} / {}: {} = {}", e.dataset, e.frame, e.method, e.metric, row[3]);
    if (compared) {
      row.push_back(value_text(e.baseline));
      caption += ", before " + row.back();
    }
    row.push_back(fmt::format("{} --filter '^{}$'", command, literal_pattern(e.dataset + '/' + e.frame)));
    table.rows.push_back(std::move(row));
    section.pictures.push_back({std::move(caption), e.picture});
  }
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace facet
