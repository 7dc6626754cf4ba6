#include "synth_io/checksums.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <openssl/evp.h>
#include <sstream>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

std::string sha256_of(const std::filesystem::path& file) {
  const std::vector<std::uint8_t> bytes = read_file_bytes(file);
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw Error(ErrorKind::internal, "SHA-256 is not available in this OpenSSL");
  }
  std::string text;
  for (unsigned int k = 0; k < size; ++k) {
    text += "0123456789abcdef"[digest[k] >> 4];
    text += "0123456789abcdef"[digest[k] & 15];
  }
  return text;
}

std::vector<std::string> files_below(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = std::filesystem::relative(entry.path(), folder).generic_string();
    if (entry.is_regular_file() && name != checksum_list) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

void write_checksums(const std::filesystem::path& folder, const std::string& left_out) {
  std::string text;
  for (const std::string& name : files_below(folder)) {
    if (name != left_out) text += sha256_of(folder / name) + "  " + name + "\n";
  }
  write_file_atomically(folder / checksum_list, text);
}

std::vector<std::string> checksum_problems(const std::filesystem::path& folder) {
  if (!std::filesystem::is_regular_file(folder / checksum_list)) {
    return {printable(folder / checksum_list) + ": is missing"};
  }
  const std::vector<std::uint8_t> bytes = read_file_bytes(folder / checksum_list);
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  std::map<std::string, std::string> expected;
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > 66) expected[line.substr(66)] = line.substr(0, 64);
  }
  std::vector<std::string> problems;
  for (const std::string& name : files_below(folder)) {
    const auto place = expected.find(name);
    if (place == expected.end()) {
      problems.push_back(printable(folder / name) + ": is not in " + checksum_list);
      continue;
    }
    if (sha256_of(folder / name) != place->second)
      problems.push_back(printable(folder / name) + ": the checksum differs");
    expected.erase(place);
  }
  for (const auto& [name, sum] : expected) problems.push_back(printable(folder / name) + ": is missing");
  return problems;
}

}  // namespace facet
