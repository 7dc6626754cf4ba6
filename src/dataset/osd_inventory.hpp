#pragma once

#include "dataset/registry.hpp"

namespace facet {

/// Adds to the report which of the frames of OSD-0.2 are absent, and which of the files whose checksums we
/// know (datasets/osd/manifest.json) differ.
void inspect_osd(const DatasetSpec& spec, DatasetReport& report);

}  // namespace facet
