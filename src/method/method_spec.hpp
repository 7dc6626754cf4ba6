#pragma once

#include <filesystem>
#include <string>

#include "pipeline/params.hpp"

namespace facet {

/// One entry of an experiment's `methods`.
struct MethodSpec {
  std::string name = "default";
  std::string kind = "pipeline";  ///< a name of the table in method/registry.hpp
  PipelineParams params;          ///< kind pipeline
  std::filesystem::path folder;   ///< kind predictions: where they are
};

}  // namespace facet
