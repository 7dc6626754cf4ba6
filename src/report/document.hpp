#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "report/chart.hpp"

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

/// A few numbers in large type: what a reader looks for first.
struct ReportTile {
  std::string title;
  std::vector<std::pair<std::string, std::string>> values;  ///< what, how much
};

struct ReportSection {
  std::string title;
  std::vector<std::string> paragraphs;
  std::vector<ReportTable> tables;
  std::vector<ReportPicture> pictures;
  bool on_console = true;
  std::vector<ReportTile> tiles{};    ///< HTML alone; the tables say the same
  std::vector<ReportChart> charts{};  ///< HTML alone; what they show stands in tables and notes too
  bool folded = false;                ///< HTML: closed at first
};

/// What a report says, before it takes the form of a console text, Markdown, HTML, CSV or JSON.
struct Report {
  std::string title;
  std::vector<ReportSection> sections;
};

std::string render_console(const Report& report);
std::string render_markdown(const Report& report);
/// One self-contained page; pictures are read below `run_directory` and embedded.
std::string render_html(const Report& report, const std::filesystem::path& run_directory);
/// Every cell of every table, one per line: section, table, row, column, value.
std::string render_csv(const Report& report);
/// Sections with their tables, charts and paths of pictures.
std::string render_json(const Report& report);
/// Reads it back, but for charts. Throws Error{data} naming `source` where the text is no report.
Report report_from_json(const std::string& text, const std::string& source);
/// A table as a float with its caption; needs the package graphicx, which shrinks it to the line.
std::string latex_table(const ReportTable& table);

}  // namespace facet
