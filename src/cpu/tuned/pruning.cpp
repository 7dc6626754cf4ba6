#include "cpu/tuned/pruning.hpp"

#include <utility>

namespace facet {
namespace {

/// Deletes the open ends of each pass; only pixels beside deleted ones can become new ends. A pixel's flag is
/// 1 while it waits in the list.
void remove_open_ends_listed(CpuScratch& scratch, int passes, const OpenEnd& open_end,
                             ImageView<std::uint8_t> edge) {
  SparseMask& mask = scratch.mask;
  std::vector<int>&candidates = scratch.list_a, &doomed = scratch.list_b;
  const auto is_open = [&](int pixel) { return open_end(mask.x(pixel), mask.y(pixel), mask.code(pixel)); };
  mask.assign(edge, candidates);
  for (int pass = 0; pass < passes && !candidates.empty(); ++pass) {
    doomed.clear();
    for (const int pixel : candidates) {
      mask.flags(pixel) = 0;
      if (mask.has(pixel) && is_open(pixel)) doomed.push_back(pixel);
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
void grow_ends(CpuScratch& scratch, int steps, const OpenEnd& open_end, ImageView<std::uint8_t> edge,
               ImageView<const std::uint8_t> original) {
  SparseMask& mask = scratch.mask;
  std::vector<int>&front = scratch.list_a, &next = scratch.list_b, &pixels = scratch.list_c;
  mask.assign(edge, pixels);
  front.clear();
  for (const int pixel : pixels)
    if (open_end(mask.x(pixel), mask.y(pixel), mask.code(pixel))) front.push_back(pixel);
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

void prune(CpuExecutor& executor, const PruningParams& params, ImageView<const float> depth_m,
           ImageView<std::uint8_t> edge, const PruningScratch& scratch) {
  if (params.mode == PruningMode::none) return;
  const OpenEnd open_end{end_point_table, depth_m};
  if (params.mode == PruningMode::stability)
    return remove_open_ends_listed(executor.scratch(), edge.width * edge.height, open_end, edge);
  executor.copy(ImageView<const std::uint8_t>(edge), scratch.original);
  remove_open_ends_listed(executor.scratch(), params.iterations, open_end, edge);
  grow_ends(executor.scratch(), params.iterations, open_end, edge, scratch.original);
}

}  // namespace facet
