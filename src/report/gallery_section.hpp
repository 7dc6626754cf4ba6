#pragma once

#include <string>

#include "record/gallery.hpp"
#include "report/document.hpp"

namespace facet {

/// Worst frames with their pictures and, for each, the command that runs it again with the experiment in
/// `config_file`.
ReportSection gallery_section(const std::vector<GalleryEntry>& entries, const std::string& config_file);

}  // namespace facet
