#include "synth/opposition.hpp"

#include <algorithm>

namespace facet {
namespace {

struct Contact {
  Vec3d point, inward;
};

std::vector<Contact> contacts_of(const std::vector<TrueEdge>& edges, std::uint16_t surface_id) {
  constexpr std::size_t per_edge = 24;
  std::vector<Contact> contacts;
  for (const TrueEdge& edge : edges) {
    if (!edge.graspable) continue;
    for (int side = 0; side < 2; ++side) {
      if (edge.faces[side] != surface_id) continue;
      const std::size_t stride = std::max<std::size_t>(1, edge.points.size() / per_edge);
      for (std::size_t i = stride / 2; i < edge.points.size(); i += stride) {
        contacts.push_back({edge.points[i], edge.inward[side][i]});
      }
    }
  }
  return contacts;
}

bool oppose(const Contact& a, const Contact& b) {
  constexpr double cone_cos = 0.89442719;  // cos(atan(0.5))
  const Vec3d between = b.point - a.point;
  const double least = cone_cos * norm(between);
  return least > 0 && dot(between, a.inward) >= least && -dot(between, b.inward) >= least;
}

}  // namespace

bool has_opposing_edges(const std::vector<TrueEdge>& edges, std::uint16_t surface_id) {
  const std::vector<Contact> contacts = contacts_of(edges, surface_id);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (std::size_t j = i + 1; j < contacts.size(); ++j) {
      if (oppose(contacts[i], contacts[j])) return true;
    }
  }
  return false;
}

}  // namespace facet
