#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "report/document.hpp"

namespace facet {

/// Tables by target, as they stand in results/reference/.
using ReferenceTables = std::map<std::string, std::vector<ReportTable>>;

std::string to_json(const ReferenceTables& tables);
/// Throws Error{not_measured} where there is no such file, Error{data} where it is damaged.
ReferenceTables read_reference(const std::filesystem::path& file);

/// Every cell of `tables` that differs from the reference, or that one of them lacks, as one line.
std::vector<std::string> differences_from(const ReferenceTables& reference, const ReferenceTables& tables);

}  // namespace facet
