#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace facet {

/// What a check of annotations found.
struct ValidationReport {
  std::size_t frames = 0;             ///< annotations read
  std::vector<std::string> problems;  ///< "file: shape 3: rule" and the like
};

/// Checks the annotations in a folder (and its subfolders): every `NAME.json` against every rule of the
/// format, its size against the object mask or, without one, against its own imageWidth and imageHeight, and
/// that each group_id has pixels in the mask. Masks are `NAME.objects.png` beside the annotation, or
/// `NAME.png` in `mask_folder` where that is given. Error{data} where there is no annotation at all, or where
/// a benchmark in the folder is unfinished.
ValidationReport validate_annotations(const std::filesystem::path& folder,
                                      const std::filesystem::path& mask_folder = {});

/// The same for a written benchmark, and its checksums.
ValidationReport validate_benchmark(const std::filesystem::path& folder);

}  // namespace facet
