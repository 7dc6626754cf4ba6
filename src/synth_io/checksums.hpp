#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace facet {

/// Name of the list of checksums in a folder, in the format of sha256sum.
inline constexpr const char* checksum_list = "SHA256SUMS";

/// Writes the list for all files below `folder` but `left_out`, sorted by name.
void write_checksums(const std::filesystem::path& folder, const std::string& left_out = {});
/// Files that are missing, changed or not in the list, each with its rule; one entry where there is no list.
std::vector<std::string> checksum_problems(const std::filesystem::path& folder);

}  // namespace facet
