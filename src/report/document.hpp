#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace facet {

/// A table of text; the first column is left-aligned, the others are right-aligned. A cell that starts with
/// two spaces is a part of the row above it.
struct ReportTable {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;  ///< below the table
  std::string full_rows_file;      ///< where every row stands, for renderers that cut long tables
};

struct ReportPicture {
  std::string caption;
  std::filesystem::path file;  ///< relative to the run directory
};

struct ReportSection {
  std::string title;
  std::vector<std::string> paragraphs;
  std::vector<ReportTable> tables;
  std::vector<ReportPicture> pictures;
  bool on_console = true;
};

/// What a report says, before it takes the form of a console text, Markdown or HTML.
struct Report {
  std::string title;
  std::vector<ReportSection> sections;
};

std::string render_console(const Report& report);
std::string render_markdown(const Report& report);
/// One self-contained page; pictures are read below `run_directory` and embedded.
std::string render_html(const Report& report, const std::filesystem::path& run_directory);

}  // namespace facet
