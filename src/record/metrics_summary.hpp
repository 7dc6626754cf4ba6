#pragma once

#include <string>
#include <vector>

#include "record/frame_row.hpp"
#include "record/manifest.hpp"

namespace facet {

/// metrics/summary.json: one result per method and data set, with the counts of its frames and what was
/// found. Scores are null, with the reason.
std::string metrics_summary_json(const Manifest& manifest, const std::vector<FrameRow>& rows);

}  // namespace facet
