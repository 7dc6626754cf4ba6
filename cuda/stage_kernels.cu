// Instantiates every stage with an executor that launches one generic kernel, which compiles each pixel
// operation for the device. Not linked into anything.

#include "core/launch.hpp"
#include "stage/basins.hpp"
#include "stage/crease_edges.hpp"
#include "stage/depth_edges.hpp"
#include "stage/edge_distance.hpp"
#include "stage/edge_kind.hpp"
#include "stage/fill_missing.hpp"
#include "stage/gradient.hpp"
#include "stage/hysteresis.hpp"
#include "stage/labelling.hpp"
#include "stage/morphology.hpp"
#include "stage/non_max_suppression.hpp"
#include "stage/normals.hpp"
#include "stage/outline_trim.hpp"
#include "stage/ownership.hpp"
#include "stage/pruning.hpp"
#include "stage/temporal_average.hpp"
#include "stage/thinning.hpp"
#include "stage/wiener.hpp"

namespace facet {

template <class Op>
__global__ void pixel_kernel(Op op, Size size) {
  run_pixel_thread(op, size, static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x),
                   static_cast<int>(blockIdx.y * blockDim.y + threadIdx.y));
}

/// The part of an executor that launches; memory and flags stay undefined.
struct LaunchOnlyExecutor {
  template <class T>
  struct Image {
    void resize(Size);
    Size size() const;
    ImageView<T> view();
    ImageView<const T> view() const;
  };
  template <class Op>
  void for_each_pixel(Size size, const Op& op) {
    const dim3 blocks(static_cast<unsigned>(Launch::blocks_x(size)),
                      static_cast<unsigned>(Launch::blocks_y(size)));
    pixel_kernel<<<blocks, dim3(Launch::block_width, Launch::block_height)>>>(op, size);
  }
  template <class Op>
  void for_each_set(ImageView<std::uint8_t> mask, const Op& op) {
    for_each_pixel(mask.size(), op);
  }
  template <class Op>
  std::int64_t sum_pixels(Size, const Op&);
  template <class T>
  void copy(ImageView<const T>, ImageView<T>);
  template <class T>
  void fill(ImageView<T>, T);
  int* changed_flag();
  bool take_changed();
};

void compile_every_stage(LaunchOnlyExecutor& e, ImageView<float> f, ImageView<std::uint8_t> m,
                         ImageView<std::int32_t> i, const NormalViews<float>& n, ImageView<std::uint16_t> l,
                         const Camera& c, const DepthNoise& d,
                         const TemporalHistory<LaunchOnlyExecutor>& history) {
  temporal_average(e, TemporalParams{}, d, history, f);
  fill_missing(e, FillParams{}, f, m, FillScratch{m, m, f});
  wiener(e, WienerParams{}, d, f, f, f, f);
  gradient(e, GradientParams{}, f, f, f);
  depth_gradient_strength(e, f, f, f, f, m);
  depth_jumps(e, DepthEdgeParams{}, d, f, m);
  relocate_to_occluding_side(e, f, m, m, m);
  direction_change(e, CreaseParams{}, 1.0f, d, f, f, f, CreaseScratch{f, f, f}, f, m);
  curvature_gradient(e, c, f, f, f, CreaseScratch{f, f, f}, f, m);
  inverse_depth(e, f, i);
  edge_distance(e, f, m, 5, m, m);
  fit_normals(e, 4, c, i, m, n);
  normal_change(e, CreaseParams{}, n, m, f, m);
  mark_off_floor(e, CreaseHeight{}, m);
  crease_basins(e, CreaseHeight{}, i);
  region_borders(e, i, m);
  non_max_suppression(e, f, m, 0.0f, 1.0f, m);
  hysteresis(e, m, m);
  unite(e, m, m, m);
  morphology(e, MorphologyParams{}, m, m, m);
  thin(e, m, m);
  prune(e, PruningParams{}, f, m, PruningScratch{m, m, m});
  edge_kind(e, EdgeKindParams{}, c, f, f, f, m, m, m);
  trim_outlines(e, 4.5f, 0.03f, f, f);
  label_components(e, f, m, i);
  give_back_pixels(e, 0.1f, 1.0f, d, f, l, m, l);
}

}  // namespace facet
