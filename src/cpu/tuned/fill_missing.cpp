#include "cpu/tuned/fill_missing.hpp"

#include <span>
#include <utility>

#include "core/clones.hpp"
#include "core/sparse_row.hpp"
#include "cpu/tuned/fill_rims.hpp"

namespace facet {
namespace {

FACET_CPU_CLONES void mark_missing(const float* depth_m, int width, std::uint8_t* missing) {
  for (int x = 0; x < width; ++x) missing[x] = !(depth_m[x] > 0);
}

FACET_CPU_CLONES void copy_sources(const float* depth_m, const std::uint8_t* rim, int width, float* source) {
  for (int x = 0; x < width; ++x) source[x] = rim[x] ? 0.0f : depth_m[x];
}

/// Marks those of the missing pixels that lie in a run between two measured ones, along their row or their
/// column, that is no longer than the limit. A run is seen from the measured pixel at its end.
void mark_narrow_holes(ImageView<const std::uint8_t> missing, int max_hole_px, ImageView<std::uint8_t> open) {
  const auto mark_run_before = [&](int x, int y, int dx, int dy) {
    int length = 0;
    int px = x - dx, py = y - dy;
    while (missing.size().contains(px, py) && missing(px, py) && length <= max_hole_px)
      px -= dx, py -= dy, ++length;
    if (length > max_hole_px || !missing.size().contains(px, py)) return;
    for (int k = 1; k <= length; ++k) open(x - k * dx, y - k * dy) = 1;
  };
  for (int y = 0; y < missing.height; ++y)
    for_each_set_in_row(missing.row(y), missing.width, [&](int x) {
      if (x + 1 < missing.width && !missing(x + 1, y)) mark_run_before(x + 1, y, 1, 0);
      if (y + 1 < missing.height && !missing(x, y + 1)) mark_run_before(x, y + 1, 0, 1);
    });
}

/// What the pixels of a front are filled with.
void propose(CpuExecutor& executor, const FillGrid& grid, std::span<const int> front,
             std::vector<float>& proposal_m) {
  std::vector<FillOffers>& offers = executor.scratch().fill_offers;
  offers.resize(static_cast<std::size_t>(executor.workers()));
  proposal_m.resize(front.size());
  executor.for_each_part(front.size(), 128, [&](std::size_t i, std::size_t begin, std::size_t end) {
    grid.propose(offers[i], front.subspan(begin, end - begin), proposal_m.data() + begin);
  });
}

/// Fills the grid from the borders of its holes inwards; the pixels filled are added to list_c.
void fill_from_borders(CpuExecutor& executor, int max_passes) {
  CpuScratch& memory = executor.scratch();
  FillGrid& grid = memory.fill_grid;
  std::vector<int>&front = memory.list_a, &next = memory.list_b, &closed = memory.list_c;
  std::vector<float>& proposal_m = memory.values;
  for (int pass = 0; pass < max_passes && !front.empty(); ++pass) {
    propose(executor, grid, front, proposal_m);
    for (std::size_t i = 0; i < front.size(); ++i) grid.close(front[i], proposal_m[i]);
    grid.list_open_beside(front, next);
    closed.insert(closed.end(), front.begin(), front.end());
    std::swap(front, next);
  }
}

}  // namespace

void fill_missing(CpuExecutor& executor, const FillParams& params, ImageView<float> depth_m,
                  ImageView<std::uint8_t> filled, const FillScratch& scratch) {
  CpuScratch& memory = executor.scratch();
  FillGrid& grid = memory.fill_grid;
  grid.resize(depth_m.size());
  const ImageView<std::uint8_t> missing = params.max_hole_px == 0 ? grid.open() : scratch.open;
  executor.for_each_row(depth_m.height,
                        [&](int y) { mark_missing(depth_m.row(y), depth_m.width, missing.row(y)); });
  if (params.max_hole_px > 0) mark_narrow_holes(missing, params.max_hole_px, grid.open());
  executor.fill(scratch.rim, std::uint8_t{0});
  if (params.prefer == FillPrefer::far) mark_rims(memory, params, depth_m, missing, scratch.rim);
  executor.for_each_row(depth_m.height, [&](int y) {
    copy_sources(depth_m.row(y), scratch.rim.row(y), depth_m.width, grid.source().row(y));
  });

  memory.list_c.clear();
  grid.list_open_beside_sources(memory.list_a);
  fill_from_borders(executor, params.max_passes);

  executor.fill(filled, std::uint8_t{0});
  const std::vector<int>& closed = memory.list_c;
  executor.for_each_part(closed.size(), 1024, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const int x = grid.x(closed[i]), y = grid.y(closed[i]);
      depth_m(x, y) = grid.source_at(closed[i]);
      filled(x, y) = 1;
    }
  });
}

}  // namespace facet
