#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace facet {

/// The header of a PNG file (ISO/IEC 15948, chunk IHDR).
struct PngHeader {
  std::uint32_t width = 0, height = 0;
  int bit_depth = 0;
  int colour_type = 0;  ///< 0 grey, 2 colour, 3 palette, 4 grey and alpha, 6 colour and alpha

  bool is_grey() const { return colour_type == 0; }
  std::string kind() const;  ///< for messages, for example "8-bit palette image"
};

/// Whether the bytes begin like a PNG file.
bool is_png(std::span<const std::uint8_t> bytes);

/// Walks the chunks from the signature to IEND and checks lengths and checksums. Decoders differ in what they
/// do with a file that breaks off, some return half an image; this refuses it. Returns the header, or nothing
/// and the broken rule in `problem`.
std::optional<PngHeader> check_png(std::span<const std::uint8_t> bytes, std::string& problem);

}  // namespace facet
