#pragma once

#include <string>

#include "dataset/registry.hpp"
#include "dataset/verify.hpp"

namespace facet {

/// A data set named on the command line: a reader's name, a synthetic benchmark (spec or folder), or a
/// folder, which the reader `folder` reads. Throws Error{data} for anything else.
DatasetSpec dataset_called(const std::string& name_or_folder);

/// With the annotations that come with the program for a data set of that name, where it has some and they
/// still lie beside its sources.
DatasetSpec with_shipped_annotations(DatasetSpec spec);

/// What `dataset info` and `dataset verify` print.
std::string describe_dataset(const DatasetSpec& spec, const Dataset& data);
std::string describe_report(const DatasetSpec& spec, const DatasetReport& report);

}  // namespace facet
