#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facet {

/// Valid UTF-8 for messages and JSON: bytes that are not UTF-8 appear as %XX.
std::string escaped_utf8(std::string_view bytes);
std::string printable(const std::filesystem::path& path);

/// The whole file. Throws Error{data} where it is missing, no regular file, empty or unreadable.
std::vector<std::uint8_t> read_file_bytes(const std::filesystem::path& path);

/// Publishes a file by an atomic rename, so that readers see the old contents, the new ones or nothing, never
/// a part. Creates missing folders. Throws Error{internal} where the disk is full or the place is not
/// writable.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file_atomically(const std::filesystem::path& path, std::string_view text);
/// Removes the temporary files that a program killed while publishing left below `folder`.
void remove_temporary_files(const std::filesystem::path& folder);

}  // namespace facet
