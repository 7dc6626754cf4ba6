#pragma once

#include <string>

namespace facet {

/// What this machine and this binary are, as JSON: env.json and `facet doctor`. What cannot be known is null
/// with a reason beside it.
std::string environment_json();

}  // namespace facet
