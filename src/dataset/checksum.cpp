#include "dataset/checksum.hpp"

#include <array>
#include <openssl/evp.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

namespace facet {

std::string sha256_hex(std::span<const std::uint8_t> bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1)
    throw Error(ErrorKind::internal, "SHA-256 is not available in this OpenSSL");
  constexpr std::string_view digits = "0123456789abcdef";
  std::string hex;
  for (unsigned int i = 0; i < size; ++i) hex.append({digits[digest[i] >> 4], digits[digest[i] & 15]});
  return hex;
}

std::string sha256_of_file(const std::filesystem::path& path) {
  return sha256_hex(read_file_bytes(path));
}

}  // namespace facet
