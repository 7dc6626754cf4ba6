#include <algorithm>
#include <fmt/format.h>

#include "report/document.hpp"

namespace facet {
namespace {

constexpr std::size_t rows_on_console = 30;

/// Columns that a UTF-8 text takes (one per code point: the reports use no wide characters).
std::size_t columns_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string space(width - std::min(width, columns_of(text)), ' ');
  return right ? space + text : text + space;
}

std::string table_text(const ReportTable& table) {
  const std::size_t shown = std::min(rows_on_console, table.rows.size());
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < table.header.size(); ++c) {
    widths.push_back(columns_of(table.header[c]));
    for (std::size_t r = 0; r < shown; ++r) widths[c] = std::max(widths[c], columns_of(table.rows[r][c]));
  }
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string text;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (c > 0) text += "  ";
      text += padded(cells[c], widths[c], c > 0);
    }
    while (text.ends_with(' ')) text.pop_back();
    text += '\n';
    return text;
  };
  std::string text = table.caption.empty() ? "" : table.caption + '\n';
  text += line(table.header);
  for (std::size_t r = 0; r < shown; ++r) text += line(table.rows[r]);
  if (shown < table.rows.size())
    text += fmt::format("... {} more in {}\n", table.rows.size() - shown, table.full_rows_file);
  for (const std::string& note : table.notes) text += note + '\n';
  return text;
}

}  // namespace

std::string render_console(const Report& report) {
  std::string text = report.title + '\n';
  for (const ReportSection& section : report.sections) {
    if (!section.on_console) continue;
    text += fmt::format("\n{}\n{:-<{}}\n", section.title, "", section.title.size());
    for (const std::string& paragraph : section.paragraphs) text += paragraph + '\n';
    for (std::size_t i = 0; i < section.tables.size(); ++i) {
      if (i > 0) text += '\n';
      text += table_text(section.tables[i]);
    }
  }
  return text;
}

}  // namespace facet
