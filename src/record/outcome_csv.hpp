#pragma once

#include <string>
#include <vector>

#include "record/frame_row.hpp"

namespace facet {

/// metrics/surfaces.csv: every surface of the truth that counts, under every method, with the region that was
/// found for it.
std::string surfaces_csv(const std::vector<FrameRow>& rows);
/// metrics/edges.csv: every edge of the truth that counts, with the samples of it that were found.
std::string edges_csv(const std::vector<FrameRow>& rows);

}  // namespace facet
