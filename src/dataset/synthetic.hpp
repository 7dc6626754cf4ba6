#pragma once

#include <memory>
#include <span>

#include "dataset/registry.hpp"

namespace facet {

std::span<const OptionInfo> synthetic_options();

/// Built-in scenes, rendered when they are loaded: no files, exact object masks.
std::unique_ptr<Dataset> open_synthetic(const DatasetSpec& spec);

}  // namespace facet
