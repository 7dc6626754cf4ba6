#include "file/png_structure.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <zlib.h>

namespace facet {
namespace {

constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t length_bytes = 4, type_bytes = 4, checksum_bytes = 4, header_bytes = 13;

std::uint32_t big_endian(std::span<const std::uint8_t> b) {
  return std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 | std::uint32_t{b[2]} << 8 |
         std::uint32_t{b[3]};
}

struct Chunk {
  std::string_view type;
  std::span<const std::uint8_t> data;
};

/// Takes the first chunk off `rest`.
std::optional<Chunk> take_chunk(std::span<const std::uint8_t>& rest, std::string& problem) {
  constexpr std::size_t overhead = length_bytes + type_bytes + checksum_bytes;
  if (rest.size() < overhead || big_endian(rest) > rest.size() - overhead) {
    problem = "PNG file is truncated";
    return std::nullopt;
  }
  const std::size_t length = big_endian(rest);
  const auto checked = rest.subspan(length_bytes, type_bytes + length);
  const auto stored = big_endian(rest.subspan(length_bytes + type_bytes + length));
  if (::crc32(0, checked.data(), static_cast<uInt>(checked.size())) != stored) {
    problem = "PNG file is corrupt (a chunk's checksum is wrong)";
    return std::nullopt;
  }
  rest = rest.subspan(overhead + length);
  return Chunk{{reinterpret_cast<const char*>(checked.data()), type_bytes}, checked.subspan(type_bytes)};
}

}  // namespace

std::string PngHeader::kind() const {
  constexpr std::array<std::string_view, 7> names{"grey",           "unknown", "colour",          "palette",
                                                  "grey-and-alpha", "unknown", "colour-and-alpha"};
  const std::string_view name = colour_type >= 0 && colour_type < 7 ? names[colour_type] : "unknown";
  return std::to_string(bit_depth) + "-bit " + std::string(name) + " image";
}

bool is_png(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= signature.size() && std::equal(signature.begin(), signature.end(), bytes.begin());
}

std::optional<PngHeader> check_png(std::span<const std::uint8_t> bytes, std::string& problem) {
  if (!is_png(bytes)) {
    problem = "is not a PNG file";
    return std::nullopt;
  }
  auto rest = bytes.subspan(signature.size());
  auto chunk = take_chunk(rest, problem);
  if (!chunk) return std::nullopt;
  if (chunk->type != "IHDR" || chunk->data.size() != header_bytes) {
    problem = "PNG file does not begin with its header";
    return std::nullopt;
  }
  const PngHeader header{big_endian(chunk->data), big_endian(chunk->data.subspan(4)), chunk->data[8],
                         chunk->data[9]};
  while (chunk->type != "IEND")
    if (chunk = take_chunk(rest, problem); !chunk) return std::nullopt;
  return header;
}

}  // namespace facet
