#include "cpu/tuned/edge_kind.hpp"

#include "core/clones.hpp"
#include "cpu/pack_bits.hpp"

namespace facet {
namespace {

constexpr std::uint8_t depth_code = edge_code(EdgeKind::depth, true);

FACET_CPU_CLONES void set_codes(int width, std::uint8_t* code) {
  for (int x = 0; x < width; ++x) code[x] = code[x] ? depth_code : std::uint8_t{0};
}

}  // namespace

void edge_kind(CpuExecutor& executor, const EdgeKindParams& params, const Camera& camera,
               ImageView<const float> depth_m, ImageView<const float> gx, ImageView<const float> gy,
               ImageView<const std::uint8_t> depth_edge, ImageView<std::uint8_t> edge,
               ImageView<std::uint8_t> code) {
  auto& [near, creases, spare, unused] = executor.scratch().bits;
  pack(executor, depth_edge, near);
  dilate_square(1, near, spare);
  pack(executor, edge, creases);
  intersect(near, creases);
  subtract(creases, near);
  unpack(executor, near, code);
  const EdgeKindOp op{depth_edge,
                      params.convexity,
                      {depth_m, depth_edge},
                      {depth_m, gx, gy, camera.fx},
                      params.hessian_dead_band_per_m,
                      code};
  executor.for_each_row(edge.height, [&](int y) { set_codes(code.width, code.row(y)); });
  executor.for_each_set(creases, op);
}

}  // namespace facet
