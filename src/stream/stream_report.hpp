#pragma once

#include <string>
#include <vector>

#include "report/document.hpp"
#include "stream/stream_record.hpp"

namespace facet {

/// What streams have measured, for all renderers: whether the rate was sustained, the paper's limit of 30 ms,
/// latencies, queues, memory.
Report make_stream_report(const std::string& experiment, const std::vector<StreamRecord>& records);

/// stream.json: the same figures as numbers. null where there is no number, with a reason beside it.
std::string stream_json(const std::vector<StreamRecord>& records);

/// timing/stream.csv: a line for every processed frame, warm-up too.
std::string stream_csv(const std::vector<StreamRecord>& records);

}  // namespace facet
