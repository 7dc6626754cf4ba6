#include "cpu/tuned/pruning.hpp"

#include <utility>

namespace facet {
namespace {

bool is_end_point(const SparseMask& mask, Size size, int pixel) {
  const unsigned code = mask.code(pixel);
  return end_point_table[code] && !meets_image_border(size, mask.x(pixel), mask.y(pixel), code);
}

/// Deletes the end points of each pass; only pixels beside deleted ones can become new end points. A pixel's flag is
/// 1 while it waits in the list.
void remove_end_points_listed(CpuScratch& scratch, int passes, ImageView<std::uint8_t> edge) {
  SparseMask& mask = scratch.mask;
  std::vector<int>&candidates = scratch.list_a, &doomed = scratch.list_b;
  mask.assign(edge, candidates);
  for (int pass = 0; pass < passes && !candidates.empty(); ++pass) {
    doomed.clear();
    for (const int pixel : candidates) {
      mask.flags(pixel) = 0;
      if (mask.has(pixel) && is_end_point(mask, edge.size(), pixel)) doomed.push_back(pixel);
    }
    candidates.clear();
    for (const int pixel : doomed) {
      edge(mask.x(pixel), mask.y(pixel)) = 0;
      mask.remove(pixel, [&](int neighbour) {
        if (mask.flags(neighbour)) return;
        mask.flags(neighbour) = 1;
        candidates.push_back(neighbour);
      });
    }
  }
}

/// Grows the ends of `edge` back along `original`, `steps` pixels at most.
void grow_ends(CpuScratch& scratch, int steps, ImageView<std::uint8_t> edge,
               ImageView<const std::uint8_t> original) {
  SparseMask& mask = scratch.mask;
  std::vector<int>&front = scratch.list_a, &next = scratch.list_b, &pixels = scratch.list_c;
  mask.assign(edge, pixels);
  front.clear();
  for (const int pixel : pixels)
    if (is_end_point(mask, edge.size(), pixel)) front.push_back(pixel);
  mask.assign(original, pixels);
  for (const int pixel : front) mask.flags(pixel) = 1;
  for (int step = 0; step < steps && !front.empty(); ++step) {
    next.clear();
    for (const int pixel : front)
      mask.for_each_neighbour(pixel, [&](int neighbour) {
        if (mask.flags(neighbour)) return;
        mask.flags(neighbour) = 1;
        next.push_back(neighbour);
        edge(mask.x(neighbour), mask.y(neighbour)) = 1;
      });
    std::swap(front, next);
  }
}

}  // namespace

void prune(CpuExecutor& executor, const PruningParams& params, ImageView<std::uint8_t> edge,
           const PruningScratch& scratch) {
  if (params.mode == PruningMode::none) return;
  if (params.mode == PruningMode::stability)
    return remove_end_points_listed(executor.scratch(), edge.width * edge.height, edge);
  executor.copy(ImageView<const std::uint8_t>(edge), scratch.original);
  remove_end_points_listed(executor.scratch(), params.iterations, edge);
  grow_ends(executor.scratch(), params.iterations, edge, scratch.original);
}

}  // namespace facet
