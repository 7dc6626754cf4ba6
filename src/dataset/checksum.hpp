#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace facet {

/// SHA-256 (FIPS 180-4) as 64 lower-case hexadecimal digits.
std::string sha256_hex(std::span<const std::uint8_t> bytes);
/// Of a file's contents; throws Error{data} where it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace facet
