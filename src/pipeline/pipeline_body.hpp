#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "pipeline/buffers.hpp"
#include "pipeline/crease_by_normals.hpp"
#include "pipeline/gradient_use.hpp"
#include "pipeline/number_regions.hpp"
#include "pipeline/params.hpp"
#include "pipeline/result.hpp"
#include "pipeline/stage_range.hpp"
#include "pipeline/temporal_window.hpp"
#include "stage/basins.hpp"
#include "stage/edge_distance.hpp"
#include "stage/hysteresis.hpp"
#include "stage/labelling.hpp"
#include "stage/non_max_suppression.hpp"
#include "stage/outline_trim.hpp"
#include "stage/ownership.hpp"
#include "stage/thinning.hpp"
#include "surface/basin_merging.hpp"
#include "surface/object_grouping.hpp"
#include "surface/support.hpp"
#include "surface/surface_list.hpp"

namespace facet {

/// The whole pipeline, top to bottom, for any back end: the executor supplies images and loops, everything
/// else is shared. Stages follow section 4.2 of the paper; which variant of each runs is a matter of
/// parameters alone.
template <class Executor>
class PipelineBody {
 public:
  using History = TemporalWindow<Executor>;

  /// Bodies that take turns with the frames of one sequence share its `history`.
  PipelineBody(Executor& executor, const PipelineParams& params, std::uint64_t seed,
               std::shared_ptr<History> history = std::make_shared<History>())
      : executor_(executor),
        params_(params),
        noise_(noise_of(params.sensor)),
        seed_(seed),
        history_(std::move(history)) {}

  /// Takes a frame through some of the stages; all of them must follow each other here, frame by frame.
  void run(StageRange stages, const FrameInput& frame, FrameResult& result) {
    const auto stage = [&](StageId id, const auto& work) {
      if (stages.contains(id))
        executor_.timed(result.times.stage_ms[static_cast<std::size_t>(index_of(id))], work);
    };
    if (stages.contains(StageId::temporal)) restart(frame, result);
    executor_.timed(result.times.total_ms, [&] {
      stage(StageId::temporal, [&] { average_frames(frame, result); });
      stage(StageId::fill, [&] {
        trim_near_outlines();
        fill_holes(b_.averaged.view());
      });
      stage(StageId::wiener, [&] { filter_noise(); });
      stage(StageId::gradient, [&] { differentiate(); });
      stage(StageId::depth_strength, [&] { rate_depth_edges(); });
      stage(StageId::depth_canny, [&] { trace_depth_edges(); });
      stage(StageId::crease_strength, [&] { rate_creases(); });
      stage(StageId::crease_canny, [&] { trace_creases(); });
      stage(StageId::morphology, [&] { smooth_edges(); });
      stage(StageId::labelling, [&] { label_regions(result); });
      stage(StageId::support, [&] { unite_support(result); });
      stage(StageId::contours, [&] { trace_contours(result); });
      stage(StageId::validation, [&] { validate_surfaces(result); });
      stage(StageId::pose, [&] { estimate_poses(result); });
      stage(StageId::grasps, [&] { find_grasps(result); });
      stage(StageId::objects, [&] { group_objects(result); });
    });
  }

  void process(const FrameInput& frame, FrameResult& result) { run(all_stages, frame, result); }

  void reset_history() { history_->clear(); }

 private:
  void restart(const FrameInput& frame, FrameResult& result) {
    const Size size = frame.depth_m.size();
    camera_ = frame.camera;
    b_.resize(size);
    result.labels.resize(size);
    numbered_.resize(size);
    result.edges.resize(size);
    result.surfaces.clear();
    result.rejected.clear();
    result.note.clear();
    result.times = {};
  }

  void average_frames(const FrameInput& frame, FrameResult& result) {  // section 3.4.2, eq. 3
    result.window = {};
    if (!params_.temporal.enabled)
      return upload_depth(executor_, frame.depth_m, frame.counts, b_.averaged.view());
    history_->take(executor_, params_.temporal, noise_, frame);
    temporal_average(executor_, params_.temporal, noise_, history_->frames(), b_.averaged.view());
    result.window = history_->use();
  }

  void trim_near_outlines() {
    const float radius_px = fattening_px(params_.outline, params_.sensor);
    if (radius_px <= 0) return;
    executor_.copy(std::as_const(b_.averaged).view(), b_.scratch_b.view());
    fill_holes(b_.scratch_b.view());
    trim_outlines(executor_, radius_px, params_.outline.jump_ratio, b_.scratch_b.view(), b_.averaged.view());
  }

  void fill_holes(ImageView<float> depth_m) {  // section 3.4.3, Algorithm 1
    const FillScratch scratch{b_.mask_a.view(), b_.mask_b.view(), b_.scratch_a.view()};
    if (params_.fill.enabled)
      fill_missing(executor_, params_.fill, depth_m, b_.filled.view(), scratch);
    else
      executor_.fill(b_.filled.view(), std::uint8_t{0});
  }

  void filter_noise() {  // section 3.4.1, eq. 2
    if (!params_.wiener.enabled) return std::swap(b_.averaged, b_.depth);
    wiener(executor_, params_.wiener, noise_, b_.averaged.view(), b_.scratch_a.view(), b_.scratch_b.view(),
           b_.depth.view());
  }

  void differentiate() {  // eq. 5
    if (!uses_gradient(params_)) return;
    gradient(executor_, params_.gradient, b_.depth.view(), b_.gx.view(), b_.gy.view());
  }

  void rate_depth_edges() {  // section 3.1
    if (params_.dd.mode == DepthEdgeMode::canny)
      depth_gradient_strength(executor_, b_.depth.view(), b_.gx.view(), b_.gy.view(), b_.strength.view(),
                              b_.direction.view());
    else
      depth_jumps(executor_, params_.dd, noise_, b_.depth.view(), b_.depth_edge.view());
  }

  void trace_depth_edges() {  // section 4.2.1
    if (params_.dd.mode != DepthEdgeMode::canny) return;
    run_canny(params_.dd.low_per_px, params_.dd.high_per_px, b_.depth_edge);
    if (!params_.dd.relocate) return;
    relocate_to_occluding_side(executor_, b_.depth.view(), b_.direction.view(), b_.depth_edge.view(),
                               b_.mask_a.view());
    std::swap(b_.depth_edge, b_.mask_a);
  }

  void rate_creases() {  // section 3.2 and eq. 6
    const CreaseScratch scratch{b_.scratch_a.view(), b_.scratch_b.view(), b_.scratch_c.view()};
    switch (params_.cd.mode) {
      case CreaseMode::normals:
        return rate_creases_by_normals();
      case CreaseMode::paper:
        return direction_change(executor_, params_.cd, gradient_noise_factor(params_.gradient.op), noise_,
                                b_.depth.view(), b_.gx.view(), b_.gy.view(), scratch, b_.strength.view(),
                                b_.direction.view());
      case CreaseMode::gaussian:
        return curvature_gradient(executor_, camera_, b_.depth.view(), b_.gx.view(), b_.gy.view(), scratch,
                                  b_.strength.view(), b_.direction.view());
    }
  }

  void rate_creases_by_normals() {
    inverse_depth(executor_, b_.depth.view(), b_.inverse_depth.view());
    edge_distance(executor_, b_.depth.view(), b_.depth_edge.view(), params_.cd.radius_px + 1,
                  b_.distance.view(), b_.mask_a.view());
    const NormalViews<float> scratch{b_.scratch_a.view(), b_.scratch_b.view(), b_.scratch_c.view()};
    crease_by_normals(executor_, params_.cd, camera_, b_.inverse_depth.view(), b_.distance.view(), scratch,
                      b_.strength.view(), b_.direction.view());
  }

  void trace_creases() {  // section 4.2.1
    if (params_.cd.closure == CreaseClosure::basins) return trace_basins();
    run_canny(crease_strength_of(params_.cd.low_deg), crease_strength_of(params_.cd.high_deg),
              b_.crease_edge);
  }

  /// Strength for an angle: fitted normals are compared by their chord, directions by degrees.
  float crease_strength_of(float deg) const {
    return params_.cd.mode == CreaseMode::normals ? chord_of(deg) : deg;
  }

  /// Closed creases: the borders that are left between the basins of the crease strength after merging.
  void trace_basins() {
    const CreaseHeight height{b_.strength.view(), b_.distance.view(), params_.cd.depth_guard_px,
                              crease_strength_of(params_.cd.floor_deg)};
    mark_off_floor(executor_, height, b_.mask_a.view());
    label_components(executor_, b_.depth.view(), b_.mask_a.view(), b_.root.view());
    crease_basins(executor_, height, b_.root.view());
    known_strength(executor_, height, b_.scratch_a.view());
    executor_.fetch(b_.root, b_.inverse_depth, b_.scratch_a);
    const BasinLandscape landscape{executor_.on_host(b_.root),
                                   executor_.on_host(b_.inverse_depth),
                                   1 / double{InverseDepthOp::units_per_inverse_metre},
                                   executor_.on_host(b_.scratch_a),
                                   height.floor,
                                   camera_};
    merging_.merge(executor_, landscape, params_.merge, noise_, regions_);
    executor_.upload(std::as_const(regions_).view(), b_.root.view());
    region_borders(executor_, b_.root.view(), b_.crease_edge.view());
  }

  void run_canny(float low, float high, typename Executor::template Image<std::uint8_t>& edge) {
    non_max_suppression(executor_, b_.strength.view(), b_.direction.view(), low, high, b_.ridge.view());
    hysteresis(executor_, b_.ridge.view(), edge.view());
  }

  void smooth_edges() {  // sections 3.3 and 4.2.2, eqs 7-10
    unite(executor_, b_.depth_edge.view(), b_.crease_edge.view(), b_.edge.view());
    morphology(executor_, params_.morphology, b_.edge.view(), b_.mask_a.view(), b_.mask_b.view());
    thin(executor_, b_.edge.view(), b_.mask_a.view());
    prune(executor_, params_.pruning, b_.depth.view(), b_.edge.view(),
          {b_.mask_a.view(), b_.mask_b.view(), b_.mask_c.view()});
    edge_kind(executor_, params_.edge_kind, camera_, b_.depth.view(), b_.gx.view(), b_.gy.view(),
              b_.depth_edge.view(), b_.edge.view(), b_.code.view());
  }

  void label_regions(FrameResult& result) {  // section 3.3: closed whatever the edges do
    const int count = number_regions(executor_, b_, params_, camera_, numbering_, numbered_, result.rejected);
    give_back_pixels(executor_, params_.dd.jump_ratio, params_.dd.noise_sigmas, noise_, b_.depth.view(),
                     b_.label.view(), b_.mask_a.view(), b_.owner.view());
    executor_.download(b_.label.view(), result.labels.view());
    executor_.download(b_.code.view(), result.edges.view());
    result.surfaces.resize(static_cast<std::size_t>(count));
  }

  void collect_pixels(FrameResult& result, int count) {
    executor_.fetch(b_.depth, b_.filled);
    collect_pixels(result, count, executor_.on_host(b_.depth), executor_.on_host(b_.filled));
  }
  void collect_pixels(FrameResult& result, int count, ImageView<const float> depth_m,
                      ImageView<const std::uint8_t> filled) {
    pixels_.collect(result.labels.view(), count, depth_m, filled, camera_, params_.pose.max_points);
    result.surfaces.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) result.surfaces[static_cast<std::size_t>(i)].id = i + 1;
  }

  /// The paper's contours are those of the edge map, whose holes cannot be joined.
  bool joins_support() const {
    return params_.support.enabled && params_.contours.mode != ContourMode::edge_map;
  }

  void unite_support(FrameResult& result) {
    if (!joins_support()) return;
    const int before = static_cast<int>(result.surfaces.size());
    collect_pixels(result, before);
    const int count = support_.unite(
        {result.labels.view(), result.edges.view(), pixels_, camera_, noise_, params_.pose, seed_},
        params_.support);
    if (count < before) collect_pixels(result, count);
  }

  void trace_contours(FrameResult& result) {  // section 4.2.3
    if (params_.contours.mode == ContourMode::edge_map) return trace_edges(result);
    if (!joins_support()) collect_pixels(result, static_cast<int>(result.surfaces.size()));
    trace_regions(result.labels.view(), pixels_.boxes, result.surfaces);
  }

  void trace_edges(FrameResult& result) {
    executor_.fetch(b_.edge, b_.depth, b_.filled);
    const auto edge = executor_.on_host(b_.edge);
    const auto depth_m = executor_.on_host(b_.depth);
    const auto filled = executor_.on_host(b_.filled);
    executor_.share_out(2, [&](int i, int) {  // neither needs the other
      if (i == 0)
        collect_pixels(result, static_cast<int>(result.surfaces.size()), depth_m, filled);
      else
        edge_borders_.follow(edge);
    });
    // The holes of the edge map are the regions as they were before edge pixels were given back.
    trace_edge_map(edge_borders_, numbered_.view(), result.surfaces);
  }

  void validate_surfaces(FrameResult& result) {
    describe_surfaces(pixels_, result.labels.size(), result.edges.view(), result.surfaces);
    drop_invalid_surfaces(params_.validation, pixels_, result.labels.view(), result.surfaces,
                          result.rejected);
    if (result.surfaces.empty())
      result.note = why_nothing_was_found(executor_.on_host(b_.depth), result.rejected);
  }

  void estimate_poses(FrameResult& result) {  // section 4.2.4
    if (!params_.pose.enabled) return;
    const PoseInput input{executor_.on_host(b_.depth), result.labels.view(), camera_, noise_, seed_};
    for_each_surface(result, [&](Surface& surface, std::size_t i, int) {
      estimate_pose(input, params_.pose, pixels_.points[i], surface);
    });
  }

  void find_grasps(FrameResult& result) {  // section 5: a graspable surface has a planar force-closure grasp
    if (!params_.grasp.enabled) return;
    const GraspInput input{
        executor_.on_host(b_.depth), result.labels.view(), result.edges.view(), camera_, noise_, seed_};
    grasps_.resize(static_cast<std::size_t>(executor_.workers()));
    for_each_surface(result, [&](Surface& surface, std::size_t, int worker) {
      grasps_[static_cast<std::size_t>(worker)].find(input, params_.grasp, surface);
    });
  }

  /// work(surface, index, worker), shared among the executor's workers: what is done to one surface depends
  /// on no other.
  template <class Work>
  void for_each_surface(FrameResult& result, const Work& work) {
    executor_.share_out(static_cast<int>(result.surfaces.size()), [&](int i, int worker) {
      const auto index = static_cast<std::size_t>(i);
      work(result.surfaces[index], index, worker);
    });
  }

  void group_objects(FrameResult& result) {  // the paper's future work
    if (!params_.objects.enabled) return;
    objects_.group({result.labels.view(), result.edges.view(), pixels_.points, camera_,
                    support_.label_in(result.labels.view()), support_.plane()},
                   params_.objects, result.surfaces);
  }

  Executor& executor_;
  PipelineParams params_;
  DepthNoise noise_;
  std::uint64_t seed_;
  std::shared_ptr<History> history_;
  Camera camera_;
  Buffers<Executor> b_;
  Image<std::int32_t> regions_;
  Image<std::uint16_t> numbered_;  ///< regions before edge pixels are given back
  BasinMerging merging_;
  RegionNumbering numbering_;
  RegionPixels pixels_;
  EdgeBorders edge_borders_;
  std::vector<GraspFinder> grasps_;  ///< by worker
  Support support_;
  ObjectGrouping objects_;
};

}  // namespace facet
