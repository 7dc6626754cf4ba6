// What averaging over time is worth on a static scene, and what it costs when the camera moves.
#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <map>
#include <numbers>

#include "core/random.hpp"
#include "cpu/cpu_pipeline.hpp"
#include "cpu/executor.hpp"
#include "pipeline/static_sequence.hpp"
#include "pipeline/temporal_gate.hpp"
#include "score/intervals.hpp"
#include "score/stability.hpp"
#include "stage/temporal_average.hpp"

namespace facet {
namespace {

PipelineParams params_for(int frames, TemporalMode mode = TemporalMode::robust) {
  PipelineParams params;
  params.temporal.frames = frames;
  params.temporal.mode = mode;
  return params;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return sorted_quantile(values, 0.5);
}

/// Differences [m] from the exact depth, where both are known and it does not jump.
std::vector<double> residuals_m(const Image<float>& depth_m, const Image<float>& exact_m) {
  std::vector<double> residuals;
  for (int y = 1; y + 1 < exact_m.height(); ++y)
    for (int x = 1; x + 1 < exact_m.width(); ++x) {
      const float z = exact_m(x, y);
      const bool smooth = std::abs(exact_m(x - 1, y) - exact_m(x + 1, y)) < 0.01f * z &&
                          std::abs(exact_m(x, y - 1) - exact_m(x, y + 1)) < 0.01f * z;
      if (z > 0 && depth_m(x, y) > 0 && smooth) residuals.push_back(double{depth_m(x, y)} - double{z});
    }
  return residuals;
}

double deviation_m(const std::vector<double>& residuals) {
  double squares = 0;
  for (const double d : residuals) squares += d * d;
  return std::sqrt(squares / static_cast<double>(residuals.size()));
}

/// Outlines that the sensor displaces do not count here.
double median_size_m(std::vector<double> residuals) {
  for (double& d : residuals) d = std::abs(d);
  return median(std::move(residuals));
}

/// Independent standard normal numbers (Box and Muller).
float normal_at(std::uint64_t stream, std::uint64_t index) {
  const float u = 1 - random_uniform(1, stream, index), v = random_uniform(2, stream, index);
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi_v<float> * v);
}

/// The average after all the frames.
Image<float> averaged(const std::vector<Image<float>>& frames, const TemporalParams& params) {
  CpuExecutor executor;
  TemporalHistory<CpuExecutor> history;
  for (const Image<float>& frame : frames) history.push(executor, frame.view(), params.frames);
  Image<float> out(frames.front().size());
  temporal_average(executor, params, kinect_v1_noise(), history, out.view());
  return out;
}

TEST(TemporalGain, five_frames_of_independent_noise_have_half_the_residual_of_one) {
  const SequenceCamera camera(plane_and_box_view(), Sensor::kinect_v1);
  const Image<float> exact = camera.exact();
  std::vector<Image<float>> frames;
  for (int i = 0; i < 5; ++i) {
    frames.push_back(exact);
    for (int y = 0; y < exact.height(); ++y)
      for (int x = 0; x < exact.width(); ++x)
        if (float& z = frames.back()(x, y); z > 0)
          z += kinect_v1_noise().sigma_m(z) *
               normal_at(static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(y * exact.width() + x));
  }
  const double single = deviation_m(residuals_m(frames.back(), exact));
  for (const TemporalMode mode : {TemporalMode::mean, TemporalMode::robust}) {
    const double ratio =
        single / deviation_m(residuals_m(averaged(frames, {.mode = mode, .frames = 5}), exact));
    RecordProperty(mode == TemporalMode::mean ? "ratio_mean" : "ratio_robust", fmt::format("{:.3f}", ratio));
    EXPECT_GE(ratio, 2.0);
    EXPECT_LE(ratio, 2.3) << "more than the root of five is no average";
  }
}

/// Median angle [deg] between the normals of planes that last, and their mean.
double normal_jitter_deg(const SequenceCamera& camera, int window_frames) {
  const auto pipeline = make_cpu_pipeline(params_for(window_frames), 1);
  StabilityTracker tracker;
  FrameResult result;
  std::map<int, std::vector<Vec3d>> tracks;
  for (int i = 0; i < 24; ++i) {
    const Image<float> depth_m = camera.measured(static_cast<std::uint64_t>(i));
    pipeline->process({depth_m.view(), camera.camera(), i / 30.0}, result);
    Prediction prediction;
    prediction.labels = result.labels;
    prediction.surfaces = result.surfaces;
    const FrameStability row = tracker.next({depth_m.view(), camera.camera(), {}, prediction});
    if (i < 4) continue;  // the window fills
    EXPECT_EQ(result.window.frames, window_frames);
    for (const TrackedPlane& plane : row.planes) tracks[plane.track].push_back(plane.normal);
  }
  std::vector<double> deviations_deg;
  for (const auto& [track, normals] : tracks) {
    if (normals.size() < 10) continue;
    Vec3d mean;
    for (const Vec3d& n : normals) mean = mean + n;
    mean = normalized(mean);
    for (const Vec3d& n : normals)
      deviations_deg.push_back(std::atan2(norm(cross(mean, n)), dot(mean, n)) * 180 / std::numbers::pi);
  }
  EXPECT_GT(deviations_deg.size(), 50u);
  return median(std::move(deviations_deg));
}

TEST(TemporalGain, poses_of_a_static_scene_jitter_less_over_five_frames) {
  std::vector<double> one, five;
  const std::vector<View> views = quickstart_views(5);
  for (const std::size_t index : {1u, 4u}) {
    const SequenceCamera camera(views[index], Sensor::kinect_v1);
    one.push_back(normal_jitter_deg(camera, 1));
    five.push_back(normal_jitter_deg(camera, 5));
    EXPECT_LE(five.back(), 0.6 * one.back()) << views[index].name;
  }
  RecordProperty("jitter_deg", fmt::format("N = 1: {:.4f} and {:.4f}, N = 5: {:.4f} and {:.4f}", one[0],
                                           one[1], five[0], five[1]));
}

/// Residual [m] of the average of the last of five frames, the camera having moved by `step` between them.
double moving_residual_m(const SequenceCamera& camera, Vec3d step_m, TemporalParams params) {
  TemporalGate gate;
  std::vector<Image<float>> window;
  for (int i = 0; i < 5; ++i) {
    const Image<float> frame = camera.measured(static_cast<std::uint64_t>(i), translation(i * step_m));
    gate.admit({frame.view(), camera.camera(), i / 30.0}, params, camera.noise());
    if (gate.use().start != WindowStart::continued) window.clear();
    window.push_back(frame);
  }
  return median_size_m(residuals_m(averaged(window, params), camera.exact(translation(4 * step_m))));
}

TEST(TemporalGain, the_reset_takes_the_smear_of_a_moving_camera_away) {
  const SequenceCamera camera(quickstart_views(5)[1], Sensor::kinect_v1);
  const Vec3d step_m{0, 0.0118 / 3, 0.0118 / 3};  // 17 cm/s
  const double single = moving_residual_m(camera, step_m, {.frames = 1});
  const double smeared =
      moving_residual_m(camera, step_m, {.mode = TemporalMode::mean, .max_motion_sigmas = 0});
  const double robust = moving_residual_m(camera, step_m, {.max_motion_sigmas = 0});
  const double reset = moving_residual_m(camera, step_m, {});
  RecordProperty("residual_mm",
                 fmt::format("one frame {:.2f}, mean without reset {:.2f}, robust {:.2f}, reset {:.2f}",
                             1000 * single, 1000 * smeared, 1000 * robust, 1000 * reset));
  EXPECT_GT(smeared, 1.5 * single);
  EXPECT_GT(robust, 1.2 * single);
  EXPECT_NEAR(reset, single, 1e-9);
  EXPECT_LT(moving_residual_m(camera, {}, {}), 0.7 * moving_residual_m(camera, {}, {.frames = 1}));
}

}  // namespace
}  // namespace facet
