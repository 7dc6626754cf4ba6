#include "surface/surface_list.hpp"

#include <algorithm>
#include <utility>

namespace facet {
namespace {

bool has_graspable_edge(const Surface& surface, ImageView<const std::uint8_t> edges) {
  return std::any_of(surface.contour.outer.begin(), surface.contour.outer.end(),
                     [&](const ContourPoint& p) { return (edges(p.x, p.y) & graspable_edge_bit) != 0; });
}

ContourPoint first_pixel(ImageView<const std::uint16_t> labels, const PixelBox& box, int label) {
  int x = box.x0;
  while (labels(x, box.y0) != label) ++x;
  return {x, box.y0};
}

/// A dropped parent hands its children to its own parent.
int kept_parent(const std::vector<Surface>& surfaces, const std::vector<int>& new_id, int parent) {
  while (parent != 0 && new_id[static_cast<std::size_t>(parent)] == 0)
    parent = surfaces[static_cast<std::size_t>(parent) - 1].parent;
  return new_id[static_cast<std::size_t>(parent)];
}

void renumber(const std::vector<int>& new_id, RegionPixels& pixels, std::vector<Surface>& surfaces) {
  for (Surface& surface : surfaces) surface.children.clear();
  std::vector<int> parents(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    parents[i] = kept_parent(surfaces, new_id, surfaces[i].parent);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (new_id[i + 1] == 0) continue;
    if (kept != i) {
      surfaces[kept] = std::move(surfaces[i]);
      std::swap(pixels.points[kept], pixels.points[i]);
    }
    surfaces[kept].id = new_id[i + 1];
    surfaces[kept].parent = parents[i];
    ++kept;
  }
  surfaces.resize(kept);
  for (const Surface& surface : surfaces)
    if (surface.parent != 0)
      surfaces[static_cast<std::size_t>(surface.parent) - 1].children.push_back(surface.id);
}

}  // namespace

void describe_surfaces(const RegionPixels& pixels, Size size, ImageView<const std::uint8_t> edges,
                       std::vector<Surface>& surfaces) {
  for (Surface& surface : surfaces) {
    const std::size_t i = static_cast<std::size_t>(surface.id) - 1;
    const PixelBox& box = pixels.boxes[i];
    surface.area_px = pixels.area_px[i];
    surface.touches_border =
        box.x0 == 0 || box.y0 == 0 || box.x1 == size.width - 1 || box.y1 == size.height - 1;
    surface.graspable = has_graspable_edge(surface, edges);
  }
}

void drop_invalid_surfaces(const ValidationParams& params, RegionPixels& pixels,
                           ImageView<std::uint16_t> labels, std::vector<Surface>& surfaces,
                           std::vector<RejectedRegion>& rejected) {
  std::vector<int> new_id(surfaces.size() + 1, 0);
  int kept = 0;
  for (const Surface& surface : surfaces) {
    const std::size_t i = static_cast<std::size_t>(surface.id) - 1;
    const float valid_share =
        static_cast<float>(pixels.measured_px[i]) / static_cast<float>(pixels.area_px[i]);
    const std::string_view reason = validate_surface(params, surface, valid_share);
    if (reason.empty())
      new_id[i + 1] = ++kept;
    else
      rejected.push_back(
          {first_pixel(labels, pixels.boxes[i], surface.id), surface.area_px, std::string(reason)});
  }
  if (kept == static_cast<int>(surfaces.size())) return;
  renumber(new_id, pixels, surfaces);
  for (int y = 0; y < labels.height; ++y)
    for (int x = 0; x < labels.width; ++x) labels(x, y) = static_cast<std::uint16_t>(new_id[labels(x, y)]);
}

std::string why_nothing_was_found(ImageView<const float> depth_m,
                                  const std::vector<RejectedRegion>& rejected) {
  for (int y = 0; y < depth_m.height; ++y)
    for (int x = 0; x < depth_m.width; ++x)
      if (depth_m(x, y) > 0) {
        if (rejected.empty()) return "every measured pixel is an edge";
        return "all " + std::to_string(rejected.size()) + " regions were dropped, the first as " +
               rejected[0].reason;
      }
  return "the frame has no measured depth";
}

}  // namespace facet
