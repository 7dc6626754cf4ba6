#include "report/write_report.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "report/run_report.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

/// A page of paper holds no more rows; longer tables keep their sums.
constexpr std::size_t most_rows_on_paper = 60;

std::string table2_latex(const RunRecord& run) {
  std::string text;
  for (const std::string& dataset : run.manifest.datasets) {
    ReportTable table = table2_of_paper(run, dataset);
    if (table.rows.size() > most_rows_on_paper) {
      table.notes.push_back(
          fmt::format("Sums of {} frames; each stands in metrics/frames.csv.", table.rows.size() - 1));
      table.rows.erase(table.rows.begin(), table.rows.end() - 1);
    }
    if (!table.rows.empty()) text += latex_table(table);
  }
  return text.empty() ? "% Not scored: no frame has truth.\n" : text;
}

std::string table3_latex(const RunRecord& run) {
  std::string text;
  for (const std::string& dataset : run.manifest.datasets)
    if (const ReportTable table = table3_of_paper(run, dataset); !table.rows.empty())
      text += latex_table(table);
  return text.empty() ? "% Not timed.\n" : text;
}

void write_latex(const RunRecord& run, const fs::path& folder) {
  write_file_atomically(folder / "table2.tex", table2_latex(run));
  write_file_atomically(folder / "table3.tex", table3_latex(run));
  write_file_atomically(folder / "tables.tex",
                        latex_document("\\mbox{}\n\\input{table2.tex}\n\\input{table3.tex}\n"));
}

/// The tables of a report one after the other.
void write_latex(const Report& report, const fs::path& folder) {
  std::string body;
  for (const ReportSection& section : report.sections)
    for (const ReportTable& table : section.tables) body += latex_table(table);
  write_file_atomically(folder / "tables.tex", latex_document(body));
}

/// A stream stores its report as it is; of other runs it is made from their rows.
Report stored_report(const fs::path& file) {
  const std::vector<std::uint8_t> bytes = read_file_bytes(file);
  return report_from_json({bytes.begin(), bytes.end()}, printable(file));
}

}  // namespace

const std::vector<std::string>& report_formats() {
  static const std::vector<std::string> formats{"md", "html", "tex", "csv", "json"};
  return formats;
}

std::string latex_document(const std::string& body) {
  return "\\documentclass{article}\n\\usepackage[a4paper,landscape,margin=1.5cm]{geometry}\n\\usepackage{"
         "graphicx}\n"
         "\\begin{document}\n" +
         body + "\\end{document}\n";
}

Report write_report(const fs::path& run_directory, const std::vector<std::string>& formats) {
  for (const std::string& format : formats)
    if (std::find(report_formats().begin(), report_formats().end(), format) == report_formats().end())
      throw Error(ErrorKind::usage,
                  fmt::format("--format {}: there are {}", format, fmt::join(report_formats(), ", ")));
  const RunRecord run = read_run(run_directory);
  const fs::path folder = run_directory / "report";
  const bool is_stream = run.manifest.study == "stream";
  Report report = is_stream ? stored_report(folder / "report.json") : make_run_report(run);
  for (const std::string& format : formats) {
    if (format == "md") write_file_atomically(folder / "report.md", render_markdown(report));
    if (format == "html") write_file_atomically(folder / "report.html", render_html(report, run_directory));
    if (format == "tex" && is_stream) write_latex(report, folder);
    if (format == "tex" && !is_stream) write_latex(run, folder);
    if (format == "csv") write_file_atomically(folder / "report.csv", render_csv(report));
    if (format == "json") write_file_atomically(folder / "report.json", render_json(report));
  }
  return report;
}

}  // namespace facet
