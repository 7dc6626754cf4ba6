#pragma once

#include <optional>
#include <string>

#include "synth_io/validate_benchmark.hpp"

namespace facet {

/// Checks the annotations of what the command line names: a benchmark that was written, with its checksums;
/// else those in the folder `truth` of a data set where it has one; else those in the folder itself. Masks
/// are in `mask_folder`, else in the folder `annotation` of a data set, else beside the annotations. Throws
/// Error{data} where there is no such folder or no annotation in it.
ValidationReport validate_named(const std::string& dataset_or_folder,
                                const std::optional<std::string>& data_root,
                                const std::optional<std::string>& mask_folder);

/// What `dataset validate` prints: every problem, one a line, then the counts.
std::string describe_validation(const ValidationReport& report);

}  // namespace facet
