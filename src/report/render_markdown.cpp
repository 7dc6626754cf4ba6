#include <fmt/format.h>

#include "report/document.hpp"

namespace facet {
namespace {

/// Text that Markdown shows as it is: no cell break, no emphasis, no HTML.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n') {
      out += "<br>";
      continue;
    }
    if (std::string_view("\\|`*_<>[]#").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string cell(const std::string& text) {
  return text.starts_with("  ") ? "&nbsp;&nbsp;" + escaped(text.substr(2)) : escaped(text);
}

std::string table_text(const ReportTable& table) {
  std::string text = table.caption.empty() ? "" : fmt::format("**{}**\n\n", escaped(table.caption));
  const auto line = [](const std::vector<std::string>& cells) {
    std::string row = "|";
    for (const std::string& c : cells) row += fmt::format(" {} |", cell(c));
    return row + '\n';
  };
  text += line(table.header) + "| --- |";
  for (std::size_t c = 1; c < table.header.size(); ++c) text += " ---: |";
  text += '\n';
  for (const auto& row : table.rows) text += line(row);
  for (const std::string& note : table.notes) text += '\n' + escaped(note) + '\n';
  return text + '\n';
}

}  // namespace

std::string render_markdown(const Report& report) {
  std::string text = fmt::format("# {}\n\n", escaped(report.title));
  for (const ReportSection& section : report.sections) {
    text += fmt::format("## {}\n\n", escaped(section.title));
    for (const std::string& paragraph : section.paragraphs) text += escaped(paragraph) + "\n\n";
    for (const ReportTable& table : section.tables) text += table_text(table);
    // The report lies in report/, the pictures beside that folder.
    for (const ReportPicture& p : section.pictures)
      text += fmt::format("![{}](<../{}>)\n\n", escaped(p.caption), p.file.generic_string());
  }
  return text;
}

}  // namespace facet
