#include "record/csv.hpp"
#include "report/document.hpp"

namespace facet {

std::string render_csv(const Report& report) {
  std::string text = csv_line({"section", "table", "row", "column", "value"});
  for (const ReportSection& section : report.sections)
    for (const ReportTable& table : section.tables)
      for (const auto& row : table.rows)
        for (std::size_t c = 1; c < row.size(); ++c)
          text += csv_line({section.title, table.caption, row[0].substr(row[0].find_first_not_of(' ')),
                            table.header[c], row[c]});
  return text;
}

}  // namespace facet
