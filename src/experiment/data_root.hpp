#pragma once

#include <optional>
#include <string>

#include "dataset/registry.hpp"

namespace facet {

/// The folder that `${data_root}` stands for: --data-root, else the environment's FACET_DATA, else none.
std::optional<std::string> find_data_root(const std::optional<std::string>& option);

/// `spec` with `${data_root}` in its root replaced. `${data_root}/osd` is searched for as DIR/osd,
/// DIR/OSD-0.2 and DIR itself. Throws Error{data} where the root needs a data root and there is none.
DatasetSpec locate(DatasetSpec spec, const std::optional<std::string>& data_root);

}  // namespace facet
