#pragma once

#include <filesystem>
#include <optional>

#include "core/camera.hpp"
#include "dataset/reader_options.hpp"

namespace facet {

/// Reads the matrix K = [fx 0 cx; 0 fy cy; 0 0 1] as nine numbers in text. Throws Error{data} where the file
/// holds anything else.
Camera read_intrinsics_file(const std::filesystem::path& path);

/// The camera that the options `intrinsics: [fx, fy, cx, cy]` or `intrinsics_file` (relative to `root`)
/// describe, nothing where neither is given. Throws Error{config} where both are.
std::optional<Camera> intrinsics_option(const ReaderOptions& options, const std::filesystem::path& root);

}  // namespace facet
