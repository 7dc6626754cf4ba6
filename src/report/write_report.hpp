#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/document.hpp"

namespace facet {

/// The forms a stored report takes, by their names on the command line: md, html, tex, csv, json.
const std::vector<std::string>& report_formats();

/// Renders the report of a run directory from its stored rows, images are not read again: report/report.md,
/// report.html, report.csv, report.json, and for tex table2.tex, table3.tex and tables.tex, which sets both
/// on a page. Throws Error{data} where the directory is no run, Error{usage} for an unknown format.
Report write_report(const std::filesystem::path& run_directory, const std::vector<std::string>& formats);

/// A document of its own around LaTeX code.
std::string latex_document(const std::string& body);

}  // namespace facet
