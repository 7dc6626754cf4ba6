#pragma once

#include <filesystem>
#include <functional>

namespace facet {

/// As write_file_atomically() for a library that opens its files itself: it writes to `place`, a name with
/// the same extension, which becomes `path` when that has succeeded. Throws Error{internal} where the place
/// is not writable.
void publish_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path& place)>& write);

}  // namespace facet
