// The sensor models against real frames below FACET_DATA; skipped where they are absent.
#include <complex>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "support/real_data.hpp"
#include "synth/families.hpp"
#include "synth/kinect_v1.hpp"
#include "synth/plane_residual.hpp"
#include "synth/stereo_camera.hpp"

namespace facet {
namespace {

Image<float> read_depth(const std::filesystem::path& path) {
  const cv::Mat raw = cv::imread(path.string(), cv::IMREAD_UNCHANGED);
  Image<float> depth({raw.cols, raw.rows});
  for (int y = 0; y < raw.rows; ++y) {
    for (int x = 0; x < raw.cols; ++x) depth(x, y) = 0.001f * raw.at<std::uint16_t>(y, x);
  }
  return depth;
}

template <class Sensor>
std::vector<Image<float>> simulated(const Sensor& sensor, const Camera& camera, Size size) {
  std::vector<Image<float>> frames;
  const char* const families[] = {"boxes", "cylindrical", "mixed", "complex"};
  for (std::uint64_t k = 0; k < 4; ++k) {
    const View view = family_layout(scene_family(families[k]), 1, k, camera, size).view;
    const Rendering exact = render(PosedScene(view.scene, view.T_world_camera), camera, size);
    frames.push_back(measure(sensor, exact, camera, k));
  }
  return frames;
}

double mean_missing(const std::vector<Image<float>>& frames) {
  double sum = 0;
  for (const auto& frame : frames) sum += missing_share(frame) / static_cast<double>(frames.size());
  return sum;
}

/// Median over frames of the residual on planes near `depth_m`, scaled to exactly that depth by the square
/// law.
PatchResidual residual_at(const std::vector<Image<float>>& frames, double depth_m) {
  PatchResidual mean{};
  double n = 0;
  for (const auto& frame : frames) {
    PatchResidual r = median_residual(frame, 0.85 * depth_m, 1.15 * depth_m);
    if (r.depth_m == 0) continue;
    const double scale = depth_m / r.depth_m;
    mean.sigma_m += r.sigma_m * scale * scale;
    mean.lag1_x += r.lag1_x, mean.lag1_y += r.lag1_y;
    ++n;
  }
  return {depth_m, mean.sigma_m / n, mean.lag1_x / n, mean.lag1_y / n};
}

void expect_alike(const std::vector<Image<float>>& real, const std::vector<Image<float>>& ours) {
  EXPECT_NEAR(mean_missing(ours), mean_missing(real), 0.05);
  for (const double z : {0.68, 0.78, 1.0}) {
    const PatchResidual a = residual_at(real, z), b = residual_at(ours, z);
    EXPECT_NEAR(b.sigma_m, a.sigma_m, 0.25 * a.sigma_m) << z;
    EXPECT_NEAR(b.lag1_x, a.lag1_x, 0.15) << z;
    EXPECT_NEAR(b.lag1_y, a.lag1_y, 0.15) << z;
  }
}

/// The f b [px m] for which the inverse depths are nearest to multiples of 1 / (8 f b), apart from a common
/// offset.
double focal_baseline_of(const Image<float>& depth) {
  std::set<float> levels;
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      if (depth(x, y) > 0.6f && depth(x, y) < 1.4f) levels.insert(depth(x, y));
    }
  }
  double best = 0, best_fb = 0;
  for (double fb = 40; fb < 48; fb += 0.01) {
    std::complex<double> sum = 0;
    for (const float z : levels) sum += std::polar(1.0, 2 * M_PI * 8 * fb / static_cast<double>(z));
    if (std::abs(sum) > best) best = std::abs(sum), best_fb = fb;
  }
  return best_fb;
}

TEST(RealSensor, KinectV1AgreesWithOsdInMissingShareResidualAndCorrelation) {
  FACET_REQUIRE_DATA("osd/disparity");
  std::vector<Image<float>> real;
  for (const char* name : {"learn6.png", "test42.png", "test63.png"}) {
    real.push_back(read_depth(real_data_root() / "osd/disparity" / name));
  }
  expect_alike(real, simulated(KinectV1{}, kinect_v1_camera(), kinect_v1_size()));
}

TEST(RealSensor, KinectV1HasTheDepthStepsOfOsd) {
  FACET_REQUIRE_DATA("osd/disparity");
  const double real = focal_baseline_of(read_depth(real_data_root() / "osd/disparity/learn6.png"));
  const double ours = focal_baseline_of(simulated(KinectV1{}, kinect_v1_camera(), kinect_v1_size())[0]);
  EXPECT_NEAR(ours, 43.2, 0.011);
  EXPECT_NEAR(real, ours, 0.005 * ours);
}

TEST(RealSensor, TheStereoCameraAgreesWithTheTabletopFrames) {
  FACET_REQUIRE_DATA("tabletop");
  std::vector<Image<float>> real;
  for (int k = 0; k < 4; ++k) {
    real.push_back(read_depth(real_data_root() / "tabletop" / (std::to_string(k) + ".depth.png")));
  }
  expect_alike(real, simulated(StereoCamera{}, stereo_camera(), stereo_camera_size()));
}

}  // namespace
}  // namespace facet
