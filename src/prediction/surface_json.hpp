#pragma once

#include <filesystem>
#include <string>

#include "prediction/prediction.hpp"

namespace facet {

/// The list of surfaces, one per line, with what was rejected. Numbers that are not finite become null, with
/// the reason in a member NAME_reason.
std::string surfaces_to_json(const Prediction& prediction);

/// Reads surfaces, rejected regions and note into `prediction`, whose label image must have been read. Throws
/// Error{data} naming file, place and rule.
void read_surfaces_json(const std::filesystem::path& path, Prediction& prediction);

}  // namespace facet
