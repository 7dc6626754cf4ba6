#pragma once

#include <filesystem>

#include "compare/policy.hpp"

namespace facet {

/// Reads a policy file: `schema: 1`, `alpha`, `inconclusive: ok|fail`, and under `accuracy` and `latency` a
/// rule per metric or stage ("*" for all others) of `better`, `abs`, `rel`, `min_n`, `exact`, `level:
/// hard|soft`, `required`. Throws Error{config} with every error found.
Policy read_policy(const std::filesystem::path& file);

}  // namespace facet
