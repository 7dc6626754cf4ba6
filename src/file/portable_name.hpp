#pragma once

#include <string>
#include <string_view>

namespace facet {

/// A name that is safe as one part of a path on any file system and different for different ids: letters,
/// digits, '_', '-' and inner '.' stay, any other byte becomes %XX.
std::string portable_name(std::string_view id);

}  // namespace facet
