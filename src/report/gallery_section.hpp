#pragma once

#include <string>

#include "record/gallery.hpp"
#include "report/document.hpp"

namespace facet {

/// Worst frames with their pictures and, for each, how to run it again: `command`, for example "facet run
/// exp.yaml", with its filter.
ReportSection gallery_section(const std::vector<GalleryEntry>& entries, const std::string& command);

}  // namespace facet
