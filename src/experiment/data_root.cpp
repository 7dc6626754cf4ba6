#include "experiment/data_root.hpp"

#include <array>
#include <cstdlib>
#include <fmt/format.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view variable = "${data_root}";

/// Other places below the data root where a folder's content may lie, in order.
struct OtherPlaces {
  std::string_view folder;
  std::array<std::string_view, 2> others;
};
constexpr std::array<OtherPlaces, 1> known_places{{{"osd", {"OSD-0.2", ""}}}};

fs::path search(const fs::path& data_root, const std::string& folder) {
  const fs::path named = data_root / folder;
  if (fs::is_directory(named)) return named;
  for (const OtherPlaces& places : known_places)
    if (places.folder == folder)
      for (const std::string_view other : places.others)
        if (const fs::path place = other.empty() ? data_root : data_root / other; fs::is_directory(place))
          return place;
  return named;
}

}  // namespace

std::optional<std::string> find_data_root(const std::optional<std::string>& option) {
  if (option) return option;
  const char* environment = std::getenv("FACET_DATA");
  if (environment == nullptr || *environment == '\0') return std::nullopt;
  return environment;
}

DatasetSpec locate(DatasetSpec spec, const std::optional<std::string>& data_root) {
  const std::string root = spec.root.string();
  if (!root.starts_with(variable)) return spec;
  if (!data_root)
    throw Error(ErrorKind::data,
                fmt::format("data set '{}' lies in {}, but neither --data-root nor the environment "
                            "variable FACET_DATA is given",
                            spec.name, root));
  if (!fs::is_directory(*data_root))
    throw Error(ErrorKind::data, fmt::format("data root {}: no such folder", printable(*data_root)));
  std::string below = root.substr(variable.size());
  while (below.starts_with('/')) below.erase(0, 1);
  spec.root = below.empty() ? fs::path(*data_root) : search(*data_root, below);
  return spec;
}

}  // namespace facet
