#pragma once

#include <filesystem>
#include <string>

#include "synth/frame_plan.hpp"

namespace facet {

/// Metres per unit of the depth images.
inline constexpr double depth_unit_m = 0.0001;

/// Makes a frame and writes its files below `folder`: depth/ID.png, color/ID.png, truth/ID.json (annotation),
/// truth/ID.objects.png (object masks) and truth/ID.geometry.json. Every file is published whole, so several
/// threads and programs may write the same frame.
void write_frame_files(const SetSpec& set, const PlannedFrame& planned, const std::filesystem::path& folder);
/// Whether all of these files are there.
bool has_frame_files(const std::string& id, const std::filesystem::path& folder);

/// "17 of 20 objects found room" where a written frame has fewer objects than asked for, else empty.
/// Error{data} where its geometry cannot be read.
std::string shortfall_of(const std::string& id, const std::filesystem::path& folder);

}  // namespace facet
