#pragma once

#include <memory>
#include <span>

#include "dataset/registry.hpp"

namespace facet {

std::span<const OptionInfo> azure_mkv_options();

/// Reads the depth track of a recording that the Azure Kinect's recorder wrote. Root is the .mkv file. The
/// lens of the attached calibration is taken out of the images, pixel by nearest pixel, so that the frames
/// are those of a pinhole camera with the calibration's focal lengths and centre. Throws Error{data} where
/// the file is no such recording, Error{not_measured} where this build cannot read .mkv.
std::unique_ptr<Dataset> open_azure_mkv(const DatasetSpec& spec);

/// Whether a path is a Matroska file by its name.
bool is_mkv(const std::filesystem::path& path);

}  // namespace facet
