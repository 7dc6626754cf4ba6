#pragma once

#include <cstdint>

#include "core/host_device.hpp"

namespace facet {

/// Kinds of edges. The codes of an edge image are a kind plus, where a finger could reach,
/// graspable_edge_bit.
enum class EdgeKind : std::uint8_t { none = 0, depth = 1, convex = 2, concave = 3 };
inline constexpr std::uint8_t graspable_edge_bit = 16;

FACET_HD constexpr std::uint8_t edge_code(EdgeKind kind, bool graspable) {
  return static_cast<std::uint8_t>(static_cast<std::uint8_t>(kind) | (graspable ? graspable_edge_bit : 0));
}
FACET_HD constexpr EdgeKind edge_kind_of(std::uint8_t code) {
  return static_cast<EdgeKind>(code & ~graspable_edge_bit);
}

}  // namespace facet
