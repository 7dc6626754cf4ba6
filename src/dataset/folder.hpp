#pragma once

#include <memory>
#include <span>

#include "dataset/registry.hpp"

namespace facet {

std::span<const OptionInfo> folder_options();

/// Reads one folder of depth images, with colour images or without, as described by the options: those of the
/// folder's dataset.yaml, where it has one, overridden by those of the spec (so that read-only data can be
/// used).
std::unique_ptr<Dataset> open_folder(const DatasetSpec& spec);

}  // namespace facet
