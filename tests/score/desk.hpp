#pragma once

#include <vector>

#include "score/frame_truth.hpp"
#include "support/awkward_frames.hpp"

namespace facet {

inline ImagePath rectangle(double x0, double y0, double x1, double y1) {
  return {{x0 - 0.5, y0 - 0.5}, {x1 - 0.5, y0 - 0.5}, {x1 - 0.5, y1 - 0.5}, {x0 - 0.5, y1 - 0.5}};
}

/// 160x120, tolerance 1.5 px: two boxes on a desk before a wall. Box 1 shows its top, surface 1 (x 30-69,
/// y 20-39), and its front, surface 2 (y 40-79); box 2 its front, surface 3 (x 100-129, y 30-89). The desk
/// begins at y = 10.
inline Truth desk() {
  Truth truth{.size = {160, 120}};
  const auto add_surface = [&](int object, ImagePath path) {
    const int number = static_cast<int>(truth.surfaces.size()) + 1;
    truth.surfaces.push_back(
        {.number = number, .object = object, .graspable = true, .parts = {{path, number}}});
  };
  const auto add_edge = [&](int object, EdgeKind kind, ImagePath line) {
    const int number = static_cast<int>(truth.edges.size()) + 1;
    truth.edges.push_back({number, object, kind, kind != EdgeKind::concave, std::move(line)});
  };
  add_surface(1, rectangle(30, 20, 70, 40));
  add_surface(1, rectangle(30, 40, 70, 80));
  add_surface(2, rectangle(100, 30, 130, 90));
  truth.support.push_back({rectangle(0, 10, 160, 120), 9});
  add_edge(1, EdgeKind::depth, {{30, 20}, {69, 20}});
  add_edge(1, EdgeKind::depth, {{30, 20}, {30, 79}});
  add_edge(1, EdgeKind::depth, {{69, 20}, {69, 79}});
  add_edge(1, EdgeKind::convex, {{30, 40}, {69, 40}});
  add_edge(1, EdgeKind::concave, {{30, 79}, {69, 79}});
  add_edge(2, EdgeKind::depth, {{100, 30}, {129, 30}});
  add_edge(2, EdgeKind::depth, {{100, 30}, {100, 89}});
  add_edge(2, EdgeKind::depth, {{129, 30}, {129, 89}});
  add_edge(2, EdgeKind::concave, {{100, 89}, {129, 89}});
  return truth;
}

/// Its object masks.
inline Image<std::uint16_t> desk_masks() {
  return make_image<std::uint16_t>({160, 120}, [](int x, int y) {
    if (x >= 30 && x < 70 && y >= 20 && y < 80) return 1;
    return x >= 100 && x < 130 && y >= 30 && y < 90 ? 2 : 0;
  });
}

/// Sets the pixels x0 <= x < x1, y0 <= y < y1.
template <class T>
void fill_box(Image<T>& image, int x0, int y0, int x1, int y1, T value) {
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) image(x, y) = value;
}

}  // namespace facet
