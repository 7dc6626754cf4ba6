#pragma once

#include <string>

#include "record/run_record.hpp"

namespace facet {

/// Times of a run in the shape that github-action-benchmark calls customSmallerIsBetter: name, unit, value,
/// range.
std::string action_benchmark_json(const RunRecord& run);

/// The same in the shape of Google Benchmark's JSON: context, and one aggregate entry per stage for the
/// median and the mean, in ms.
std::string google_benchmark_json(const RunRecord& run);

}  // namespace facet
