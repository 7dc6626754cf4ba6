#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace facet {

using CsvRow = std::vector<std::string>;

/// One line of RFC 4180 with '\n' at its end; fields with commas, quotes or line breaks are quoted.
std::string csv_line(const CsvRow& fields);
/// Every row of a CSV text, its header included.
std::vector<CsvRow> parse_csv(std::string_view text);
/// Shortest text that reads back as the same number; empty where it is not finite.
std::string csv_number(double value);

}  // namespace facet
