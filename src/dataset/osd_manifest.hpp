#pragma once

namespace facet {

/// datasets/osd/manifest.json as it was when the program was built: expected frames, checksums of known
/// files.
extern const char* const osd_manifest_json;

}  // namespace facet
