#include "dataset/intrinsics.hpp"

#include <array>
#include <sstream>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

namespace facet {

Camera read_intrinsics_file(const std::filesystem::path& path) {
  const auto bytes = read_file_bytes(path);
  std::istringstream text(std::string(bytes.begin(), bytes.end()));
  text.imbue(std::locale::classic());
  std::array<float, 9> k{};
  bool good = true;
  for (float& value : k) good = good && text >> value;
  std::string more;
  good = good && !(text >> more);
  good = good && k[1] == 0 && k[3] == 0 && k[6] == 0 && k[7] == 0 && k[8] == 1;
  if (!good)
    throw Error(ErrorKind::data,
                printable(path) + ": expected the nine numbers of K = [fx 0 cx; 0 fy cy; 0 0 1]");
  return {k[0], k[4], k[2], k[5]};
}

std::optional<Camera> intrinsics_option(const ReaderOptions& options, const std::filesystem::path& root) {
  const auto numbers = numbers_option(options, "intrinsics");
  const auto file = text_option(options, "intrinsics_file");
  if (numbers && file)
    throw Error(ErrorKind::config, "options intrinsics and intrinsics_file exclude each other");
  if (file) return read_intrinsics_file(root / *file);
  if (!numbers) return std::nullopt;
  if (numbers->size() != 4) throw Error(ErrorKind::config, "option intrinsics: expected [fx, fy, cx, cy]");
  const auto at = [&](std::size_t i) { return static_cast<float>((*numbers)[i]); };
  return Camera{at(0), at(1), at(2), at(3)};
}

}  // namespace facet
