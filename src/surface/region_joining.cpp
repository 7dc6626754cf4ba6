#include "surface/region_joining.hpp"

#include <algorithm>

#include "core/angle.hpp"
#include "core/crease_strength.hpp"

namespace facet {
namespace {

/// Slope of a surface, dz/dx, that is not unusual: 63 degrees to the image plane.
constexpr double usual_slope = 2;
/// A sum of six squares of standard normal numbers, one per term of a patch, is larger in one case of 100.
constexpr double chi_square_6_99 = 16.8;

template <class T>
T& at(std::span<T> values, int i) {
  return values[static_cast<std::size_t>(i)];
}

/// Variance of q of one independent reading, times the pixels that share one.
double reading_variance(const PatchMoments& moments, const DepthNoise& noise) {
  const double q = moments.mean_q();  // noise of q = noise of z times q^2
  const double sigma = noise.sigma_m(static_cast<float>(1 / q)) * q * q;
  return double{noise.pixels_per_reading} * sigma * sigma;
}

/// Whether the patch fitted to both regions explains them as well as two do: what it adds to the squares is
/// noise or, over the smaller region, within the tolerated step.
bool explains_both(const JoiningTask& task, const PatchFit& fit, const PatchMoments& both, int a, int b) {
  const double added = fit.squares() - at(task.fits, a).squares() - at(task.fits, b).squares();
  const double fewer_px = std::min(task.graph.moments(a).count(), task.graph.moments(b).count());
  const double step = double{task.params.step_ratio} * both.mean_q();
  return added < chi_square_6_99 * reading_variance(both, task.noise) + fewer_px * step * step;
}

}  // namespace

PatchFit fit_region(const PatchMoments& moments, const MergeParams& params, const DepthNoise& noise,
                    double focal_px) {
  // A surface of radius R has dq/dx = q/f times its slope dz/dx, and d2q/dx2 = 1 / (R f^2).
  const double curvature =
      params.curve_radius_mm > 0 ? 1e3 / (params.curve_radius_mm * focal_px * focal_px) : 1e-12;
  return moments.fit(
      {reading_variance(moments, noise), usual_slope * moments.mean_q() / focal_px, curvature});
}

/// Whether a border is longer or a side larger than when it was judged.
bool RegionJoining::has_changed(const JoiningTask& task, int i) const {
  BasinGraph& graph = task.graph;
  const BasinBorder& border = graph.border(i);
  const BorderJudgement& judged = at(task.judgements, i);
  return border.length != judged.length ||
         graph.moments(graph.find(border.a)).count() + graph.moments(graph.find(border.b)).count() !=
             judged.pixels;
}

bool RegionJoining::judge(const JoiningTask& task, int i) {
  BasinGraph& graph = task.graph;
  const BasinBorder& border = graph.border(i);
  const int a = graph.find(border.a), b = graph.find(border.b);
  BorderJudgement& judged = at(task.judgements, i);
  judged = {graph.moments(a).count() + graph.moments(b).count(), border.length, judged.serial + 1};
  if (border.strength() > most_strength_) return false;
  const auto [excess, expected] =
      seam_difference(at(task.fits, a), at(task.fits, b), border.seam, task.focal_px, tolerance_);
  if (excess >= 1) return false;
  candidates_.push_back({static_cast<float>(expected), i, judged.serial});
  return true;
}

void RegionJoining::judge_anew(const JoiningTask& task, int i) {
  if (judge(task, i)) std::push_heap(candidates_.begin(), candidates_.end(), is_later);
}

bool RegionJoining::join_across(const JoiningTask& task, int i) {
  BasinGraph& graph = task.graph;
  const int a = graph.find(graph.border(i).a), b = graph.find(graph.border(i).b);
  PatchMoments both = graph.moments(a);
  both += graph.moments(b);
  const PatchFit fit = fit_region(both, task.params, task.noise, task.focal_px);
  if (!explains_both(task, fit, both, a, b)) return false;
  // Other borders of the larger one are judged anew when their turn comes.
  graph.join(a, b, touched_);
  at(task.fits, graph.find(a)) = fit;
  for (const int k : touched_) judge_anew(task, k);
  return true;
}

bool RegionJoining::join_alike(const JoiningTask& task, std::span<const int> borders, float most_strength) {
  bool joined = false;
  most_strength_ = most_strength;
  candidates_.clear();
  for (const int i : borders)
    if (task.graph.border(i).length > 0) judge(task, i);
  std::make_heap(candidates_.begin(), candidates_.end(), is_later);
  while (!candidates_.empty()) {
    std::pop_heap(candidates_.begin(), candidates_.end(), is_later);
    const Candidate best = candidates_.back();
    candidates_.pop_back();
    const bool is_gone = task.graph.border(best.border).length == 0;
    if (is_gone || best.serial != at(task.judgements, best.border).serial) continue;
    if (has_changed(task, best.border))
      judge_anew(task, best.border);
    else
      joined |= join_across(task, best.border);
  }
  return joined;
}

void RegionJoining::run(const JoiningTask& task, std::span<const int> borders) {
  tolerance_ = {task.params.crease_deg / static_cast<double>(degrees_per_radian), task.params.step_ratio,
                task.params.fit_sigmas};
  join_alike(task, borders, chord_of(task.params.flat_deg));
  while (join_alike(task, borders, unknown_strength)) {
  }
}

}  // namespace facet
