#include "stage/wiener.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "support/analytic_depth.hpp"
#include "support/every_executor.hpp"

namespace facet {
namespace {

template <class Executor>
Image<float> filtered(Executor& executor, const WienerParams& params, const DepthNoise& noise,
                      const Image<float>& depth) {
  Image<float> mean(depth.size()), variance(depth.size()), out(depth.size());
  wiener(executor, params, noise, depth.view(), mean.view(), variance.view(), out.view());
  return out;
}
Image<float> filtered(const WienerParams& params, const DepthNoise& noise, const Image<float>& depth) {
  CpuExecutor executor;
  return filtered(executor, params, noise, depth);
}

WienerParams params_of(WienerGain gain, WienerNoise noise, int window_px, bool detrend) {
  return {true, gain, noise, window_px, detrend};
}

/// Mean and variance of the valid pixels of a window, pixel by pixel, as the text around eq. 2 has them.
/// Beyond the image its nearest pixels count again. The variance is about the mean, or about the best plane
/// by the normal equations of a full window.
struct Statistics {
  double mean = 0, variance = 0;
  int valid = 0;
};
Statistics statistics_at(const Image<float>& depth, int x, int y, int radius, bool detrend) {
  std::vector<std::array<double, 3>> points;
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx) {
      const float z =
          depth(std::clamp(x + dx, 0, depth.width() - 1), std::clamp(y + dy, 0, depth.height() - 1));
      if (z > 0) points.push_back({static_cast<double>(dx), static_cast<double>(dy), static_cast<double>(z)});
    }
  Statistics s;
  s.valid = static_cast<int>(points.size());
  if (s.valid == 0) return s;
  for (const auto& p : points) s.mean += p[2] / s.valid;
  cv::Mat_<double> a(s.valid, 3), b(s.valid, 1), plane;
  for (int i = 0; i < s.valid; ++i) {
    const auto& p = points[static_cast<std::size_t>(i)];
    a(i, 0) = 1, a(i, 1) = p[0], a(i, 2) = p[1], b(i) = p[2] - s.mean;
  }
  if (detrend)
    cv::solve(a, b, plane, cv::DECOMP_SVD);
  else
    plane = cv::Mat_<double>::zeros(3, 1);
  const cv::Mat residual = b - a * plane;
  s.variance = residual.dot(residual) / s.valid;
  return s;
}

double gain_of(WienerGain gain, double variance, double noise) {
  if (gain == WienerGain::paper) return variance / (variance + noise);  // eq. 2
  return std::max(0.0, variance - noise) / std::max(variance, noise);   // Lim 1990
}

/// Compares the filter with eq. 2 evaluated pixel by pixel in double precision.
void expect_equation_2(const WienerParams& params, const Image<float>& depth, int margin) {
  const DepthNoise sensor{0.01f, 0.002f, 0.4f};
  const Image<float> out = filtered(params, sensor, depth);
  double noise_sum = 0;
  int noise_count = 0;
  const auto at = [&](int x, int y) {
    return statistics_at(depth, x, y, params.window_px / 2, params.detrend);
  };
  for (int y = 0; y < depth.height(); ++y)
    for (int x = 0; x < depth.width(); ++x) {
      const Statistics s = at(x, y);
      if (s.valid >= 5 && depth(x, y) > 0) noise_sum += s.variance, ++noise_count;
    }
  for (int y = margin; y < depth.height() - margin; ++y)
    for (int x = margin; x < depth.width() - margin; ++x) {
      const Statistics s = at(x, y);
      const double z = static_cast<double>(depth(x, y)),
                   sigma = static_cast<double>(sensor.sigma_m(depth(x, y)));
      const double noise = params.noise == WienerNoise::sensor ? sigma * sigma : noise_sum / noise_count;
      const bool passes = s.valid < 5 || z == 0;
      const double expected = passes ? z : s.mean + gain_of(params.gain, s.variance, noise) * (z - s.mean);
      EXPECT_NEAR(out(x, y), expected, 2e-6) << x << ", " << y;
    }
}

TEST(Wiener, IsEquation2OverTheValidPixels) {
  const Image<float> far = random_depth({47, 31}, 5);  // halved: the mean counts variances up to 1 m^2
  const auto depth = make_image<float>(far.size(), [&](int x, int y) { return 0.5f * far(x, y); });
  for (const WienerGain gain : {WienerGain::paper, WienerGain::lim})
    for (const WienerNoise noise : {WienerNoise::sensor, WienerNoise::mean})
      for (const int window_px : {3, 5, 7})
        expect_equation_2(params_of(gain, noise, window_px, false), depth, 0);
}

TEST(Wiener, DetrendedVarianceIsThatAboutTheLeastSquaresPlane) {
  const Image<float> depth = random_depth_without_holes({47, 31}, 5);
  for (const int window_px : {3, 5, 7})
    expect_equation_2(params_of(WienerGain::lim, WienerNoise::sensor, window_px, true), depth, window_px / 2);
}

TEST(Wiener, LeavesAConstantAsItIs) {
  const Image<float> depth(Size{33, 9}, 1.5f);
  for (const WienerGain gain : {WienerGain::paper, WienerGain::lim})
    for (const WienerNoise noise : {WienerNoise::sensor, WienerNoise::mean})
      EXPECT_TRUE(same_image(filtered(params_of(gain, noise, 5, true), kinect_v1_noise(), depth), depth));
}

TEST(Wiener, KeepsMissingPixelsMissingAndLonelyOnesAsTheyAre) {
  Image<float> depth(Size{33, 9});
  depth(10, 4) = 1.0f;
  depth(11, 4) = 1.1f;
  EXPECT_TRUE(same_image(filtered({}, kinect_v1_noise(), depth), depth));
}

TEST(Wiener, MissingPixelsDoNotPullTheirNeighbours) {
  Image<float> depth(Size{33, 9}, 1.5f);
  for (int y = 2; y < 7; ++y)
    for (int x = 14; x < 18; ++x) depth(x, y) = 0;
  EXPECT_TRUE(same_image(filtered({}, kinect_v1_noise(), depth), depth));
}

/// Gain at the centre of a checkerboard of +-1 cm whose local variance, (1 - 1/81) cm^2, is all noise.
float gain_at_noise_level(WienerGain gain) {
  const auto board = make_image<float>({9, 9}, [](int x, int y) { return (x + y) % 2 ? 1.01f : 0.99f; });
  const DepthNoise noise{0.01f * std::sqrt(80.0f / 81.0f), 0, 0};
  const float out = filtered(params_of(gain, WienerNoise::sensor, 3, false), noise, board)(4, 4);
  const float mean = 1 - 0.01f / 9;
  return (out - mean) / (0.99f - mean);
}

TEST(Wiener, AsPrintedStillPassesHalfWhereTheLocalVarianceIsAllNoise) {
  EXPECT_NEAR(gain_at_noise_level(WienerGain::paper), 0.5, 1e-3);
}

TEST(Wiener, AfterLimPassesNothingWhereTheLocalVarianceIsAllNoise) {
  EXPECT_NEAR(gain_at_noise_level(WienerGain::lim), 0, 1e-3);
}

/// Root mean square difference [m] within a frame of 4 pixels.
double rms(const Image<float>& a, const Image<float>& b) {
  double squares = 0;
  int n = 0;
  for (int y = 4; y < a.height() - 4; ++y)
    for (int x = 4; x < a.width() - 4; ++x, ++n)
      squares += std::pow(static_cast<double>(a(x, y) - b(x, y)), 2);
  return std::sqrt(squares / n);
}

Image<float> with_noise(const Image<float>& depth, float sigma_m) {
  return make_image<float>(depth.size(), [&](int x, int y) {
    float sum = -6;  // twelve uniform numbers: nearly Gaussian, deviation 1
    for (std::uint64_t k = 0; k < 12; ++k) sum += noise_at(k, x, y);
    return depth(x, y) + sigma_m * sum;
  });
}

TEST(Wiener, ReducesSensorNoiseOnAPlane) {
  const Image<float> flat(Size{120, 90}, 1.0f);
  const DepthNoise noise{0.002f, 0, 0};
  const Image<float> noisy = with_noise(flat, 0.002f);
  EXPECT_LT(rms(filtered({}, noise, noisy), flat), 0.35 * rms(noisy, flat));
}

TEST(Wiener, TakesASlopeForNoSignalWhenDetrended) {
  const Camera camera{525, 525, 60, 45};
  const Vec3 normal = tilted_normal(70, 30);
  const Image<float> slope = plane_depth({120, 90}, camera, normal, static_cast<double>(normal.z));
  const DepthNoise noise{0.002f, 0, 0};
  const Image<float> noisy = with_noise(slope, 0.002f);
  WienerParams with_trend, without_trend;
  with_trend.detrend = false;
  EXPECT_LT(rms(filtered(without_trend, noise, noisy), slope), 0.5 * rms(noisy, slope));
  EXPECT_GT(rms(filtered(with_trend, noise, noisy), slope), 0.7 * rms(noisy, slope));
}

TEST(Wiener, KeepsAStepSharp) {
  const auto step = make_image<float>({60, 40}, [](int x, int) { return x < 30 ? 1.0f : 1.1f; });
  const Image<float> out = filtered({}, kinect_v1_noise(), step);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) EXPECT_NEAR(out(x, y), step(x, y), 0.002f);
}

TEST(Wiener, IsTheSameOnEveryExecutor) {
  for_each_awkward_depth([](const Image<float>& depth) {
    const bool large = depth.width() > 100;
    for (const WienerParams& params :
         {WienerParams{}, params_of(WienerGain::paper, WienerNoise::mean, 3, false),
          params_of(WienerGain::lim, WienerNoise::mean, 7, true)}) {
      if (large && params.window_px == 7) continue;  // the shuffled grid is slow
      expect_same_on_every_executor(
          [&](auto& executor) { return filtered(executor, params, kinect_v1_noise(), depth); });
    }
  });
}

}  // namespace
}  // namespace facet
