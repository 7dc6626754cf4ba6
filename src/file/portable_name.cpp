#include "file/portable_name.hpp"

#include <cctype>
#include <fmt/format.h>

namespace facet {

std::string portable_name(std::string_view id) {
  std::string name;
  for (std::size_t i = 0; i < id.size(); ++i) {
    const auto c = static_cast<unsigned char>(id[i]);
    const bool plain = c < 128 && (std::isalnum(c) || c == '_' || c == '-' || (c == '.' && i > 0));
    name += plain ? std::string(1, id[i]) : fmt::format("%{:02X}", c);
  }
  return name;
}

}  // namespace facet
