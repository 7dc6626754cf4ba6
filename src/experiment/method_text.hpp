#pragma once

#include <string>

namespace facet {

/// A card for every kind of method: what it yields, its parameters with their ranges, where it is from, its
/// licence, and what this build lacks for it.
std::string describe_methods();

}  // namespace facet
