#include "edge_pairs/edge_map.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "cpu/tuned/depth_jumps.hpp"
#include "cpu/tuned/fill_missing.hpp"
#include "cpu/tuned/hysteresis.hpp"
#include "cpu/tuned/thinning.hpp"
#include "stage/crease_edges.hpp"
#include "stage/edge_distance.hpp"
#include "stage/gradient.hpp"
#include "stage/non_max_suppression.hpp"

namespace facet {
namespace {

/// Standard deviation of the median of nine independent readings, relative to that of one.
constexpr float median_noise = 0.41f;

template <class T>
cv::Mat mat_of(Image<T>& image) {
  return {image.height(), image.width(), cv::DataType<T>::type, image.row(0), image.stride() * sizeof(T)};
}

/// Clears the components of a 0/1 mask that have fewer pixels.
void drop_small_components(cv::Mat mask, int least_px) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centres, 8);
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x) {
      const int label = labels.at<int>(y, x);
      if (label > 0 && label < count && stats.at<int>(label, cv::CC_STAT_AREA) < least_px)
        mask.at<std::uint8_t>(y, x) = 0;
    }
}

}  // namespace

float least_jump_m(const EdgePairParams& params, const DepthNoise& noise, float depth_m) {
  return std::max(params.noise_sigmas * noise.sigma_m(depth_m), params.jump_ratio * depth_m);
}

void EdgeMap::compute(const EdgePairParams& params, const DepthNoise& noise, ImageView<const float> depth_m) {
  const Size size = depth_m.size();
  for (Image<float>* i : {&depth_, &raw_, &proposal_, &gx_, &gy_, &ux_, &uy_, &weight_, &strength_})
    i->resize(size);
  for (Image<std::uint8_t>* i :
       {&depth_edge_, &crease_edge_, &edge_, &direction_, &ridge_, &mask_a_, &mask_b_})
    i->resize(size);
  smooth(params, noise, depth_m);
  DepthEdgeParams jumps;
  jumps.jump_ratio = params.jump_ratio;
  jumps.noise_sigmas = params.noise_sigmas;
  depth_jumps(executor_, jumps, noise, std::as_const(depth_).view(), depth_edge_.view());
  trace_creases(params, noise);
  unite(params);
}

void EdgeMap::smooth(const EdgePairParams& params, const DepthNoise& noise, ImageView<const float> depth_m) {
  executor_.copy(depth_m, raw_.view());
  fill_missing(executor_, FillParams{}, raw_.view(), mask_b_.view(),
               FillScratch{mask_a_.view(), ridge_.view(), proposal_.view()});
  cv::Mat raw = mat_of(raw_), smoothed = mat_of(depth_);
  cv::medianBlur(raw, smoothed, 3);
  if (params.smoothing_px <= 1) return;
  // What differs by less than a jump at the middle of the scene is smoothed over.
  smoothed.copyTo(raw);
  const double depth = cv::mean(raw, raw > 0)[0];
  cv::bilateralFilter(raw, smoothed, params.smoothing_px,
                      0.5 * static_cast<double>(least_jump_m(params, noise, static_cast<float>(depth))),
                      params.smoothing_px / 3.0);
}

/// Canny on the direction of the depth gradient, where the gradient is more than its own noise.
void EdgeMap::trace_creases(const EdgePairParams& params, const DepthNoise& noise) {
  const GradientParams sobel;
  gradient(executor_, sobel, std::as_const(depth_).view(), gx_.view(), gy_.view());
  CreaseParams creases;
  creases.weighted = false;
  direction_change(executor_, creases, gradient_noise_factor(sobel.op), noise, std::as_const(depth_).view(),
                   std::as_const(gx_).view(), std::as_const(gy_).view(),
                   CreaseScratch{ux_.view(), uy_.view(), weight_.view()}, strength_.view(),
                   direction_.view());
  const float noise_factor = median_noise * gradient_noise_factor(sobel.op) * params.gradient_sigmas;
  for (int y = 0; y < depth_.height(); ++y)
    for (int x = 0; x < depth_.width(); ++x) {
      const float magnitude = std::hypot(gx_(x, y), gy_(x, y));
      if (!(magnitude > noise_factor * noise.sigma_m(depth_(x, y)))) strength_(x, y) = 0;
    }
  // Canny's usual ratio of its two thresholds.
  non_max_suppression(executor_, std::as_const(strength_).view(), std::as_const(direction_).view(),
                      params.crease_deg / 2, params.crease_deg, ridge_.view());
  hysteresis(executor_, ridge_.view(), crease_edge_.view());
}

/// Union of both, creases beside depth edges dropped, gaps closed, thinned, without small pieces.
void EdgeMap::unite(const EdgePairParams& params) {
  edge_distance(executor_, std::as_const(depth_).view(), std::as_const(depth_edge_).view(),
                params.depth_guard_px + 1, mask_a_.view(), mask_b_.view());
  for (int y = 0; y < edge_.height(); ++y)
    for (int x = 0; x < edge_.width(); ++x)
      edge_(x, y) =
          depth_edge_(x, y) != 0 || (crease_edge_(x, y) != 0 && mask_a_(x, y) > params.depth_guard_px);
  cv::Mat edge = mat_of(edge_);
  cv::morphologyEx(edge, edge, cv::MORPH_CLOSE, cv::Mat::ones(3, 3, CV_8U));
  thin(executor_, edge_.view(), mask_a_.view());
  drop_small_components(edge, params.min_component_px);
}

}  // namespace facet
