#include "pipeline/camera_motion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace facet {
namespace {

constexpr double everything = std::numeric_limits<double>::infinity();
constexpr double most_blocks = 5000;
constexpr double least_measured = 0.75;   ///< share of the pixels of a block
constexpr double edge_jitter_px = 0.5;    ///< of depth edges from frame to frame, whatever the sensor
constexpr double largest_change = 4;      ///< single changes count up to here [sigma]
constexpr double outlier = 3;             ///< residual of what moves by itself [sigma]
constexpr double most_outliers = 0.2;     ///< a larger share beyond `largest_change`: another view
constexpr double largest_turn_rad = 0.1;  ///< beyond it the linear model does not hold, nor any window
constexpr double noise_chi2 = 24;         ///< six numbers fitted to noise exceed it once in 2000 times
constexpr std::size_t least_blocks = 50;
/// A weak belief that the camera stands still, for what the scene does not show [1/m^2, 1/rad^2].
constexpr double stillness = 400;

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

Vector6 vector_of(const std::array<double, 6>& values) {
  return Vector6(values.data());
}

/// Blocks are so large that neighbours share no readings, and no more than can be looked at.
int block_side_px(const ImageView<const float>& depth_m, const DepthNoise& noise) {
  const double area_px = static_cast<double>(depth_m.width) * depth_m.height;
  const double block_px = std::max(area_px / most_blocks, double{noise.pixels_per_reading});
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(block_px))));
}

/// The mean of what is measured in a block; 0 where that is too little.
float mean_of_block(const ImageView<const float>& depth_m, int side_px, int block_x, int block_y) {
  float sum = 0;
  int measured = 0;
  for (int y = block_y * side_px; y < (block_y + 1) * side_px; ++y) {
    const float* row = depth_m.row(y) + block_x * side_px;
    for (int x = 0; x < side_px; ++x) {
      sum += row[x];
      measured += row[x] > 0;
    }
  }
  return measured >= least_measured * side_px * side_px ? sum / static_cast<float>(measured) : 0.0f;
}

}  // namespace

void CameraMotion::start_from(const FrameInput& frame, const DepthNoise& noise) {
  const ImageView<const float>& depth = frame.depth_m;
  side_px_ = block_side_px(depth, noise);
  T_world_camera_ = frame.T_world_camera;
  means_m_.resize({depth.width / side_px_, depth.height / side_px_});
  for (int y = 0; y < means_m_.height(); ++y)
    for (int x = 0; x < means_m_.width(); ++x) means_m_(x, y) = mean_of_block(depth, side_px_, x, y);
  blocks_.clear();
  for (int y = 1; y + 1 < means_m_.height(); ++y)
    for (int x = 1; x + 1 < means_m_.width(); ++x) add_block(frame.camera, noise, x, y);
}

void CameraMotion::add_block(const Camera& camera, const DepthNoise& noise, int x, int y) {
  const auto mean_m = [&](int dx, int dy) { return double{means_m_(x + dx, y + dy)}; };
  const double z = mean_m(0, 0), left = mean_m(-1, 0), right = mean_m(1, 0), above = mean_m(0, -1),
               below = mean_m(0, 1);
  if (!(z > 0 && left > 0 && right > 0 && above > 0 && below > 0)) return;
  const double fx = double{camera.fx}, fy = double{camera.fy};
  const double per_px_x = (right - left) / (2 * side_px_), per_px_y = (below - above) / (2 * side_px_);
  const double u = ((x + 0.5) * side_px_ - 0.5 - double{camera.cx}) / fx;
  const double v = ((y + 0.5) * side_px_ - 0.5 - double{camera.cy}) / fy;
  // A point that moves by d changes the depth at its pixel by a . d: its own, less what the slope brings
  // there.
  const double sx = per_px_x * fx, sy = per_px_y * fy;
  const Vec3d a{-sx / z, -sy / z, 1 + (sx * u + sy * v) / z};
  const Vec3d turned = cross({u * z, v * z, z}, a);
  const double jitter_m = edge_jitter_px * std::hypot(per_px_x, per_px_y);
  const double sigma_m = double{noise.sigma_m(static_cast<float>(z))};
  const double k = 1 / std::sqrt(2 * (sigma_m * sigma_m + jitter_m * jitter_m));
  // Points move against the camera.
  blocks_.push_back(
      {x, y, z, k, {-a.x * k, -a.y * k, -a.z * k, -turned.x * k, -turned.y * k, -turned.z * k}});
}

double CameraMotion::change_sigmas(const FrameInput& frame) {
  if (T_world_camera_ && frame.T_world_camera)
    return change_by_pose(T_world_camera_->inverse() * *frame.T_world_camera);
  return change_by_depth(frame);
}

double CameraMotion::change_by_pose(const RigidMotion& T_start_now) const {
  const RigidMotion& m = T_start_now;
  const bool turned_far = m.ex.x + m.ey.y + m.ez.z < 1 + 2 * std::cos(largest_turn_rad);
  if (turned_far) return everything;
  const std::array<double, 6> motion{m.origin.x,
                                     m.origin.y,
                                     m.origin.z,
                                     0.5 * (m.ey.z - m.ez.y),
                                     0.5 * (m.ez.x - m.ex.z),
                                     0.5 * (m.ex.y - m.ey.x)};
  double squares = 0;
  for (const Block& block : blocks_) {
    const double change = vector_of(block.response).dot(vector_of(motion));
    squares += change * change;
  }
  return blocks_.empty() ? 0 : std::sqrt(squares / static_cast<double>(blocks_.size()));
}

double CameraMotion::change_by_depth(const FrameInput& frame) {
  changes_.clear();
  std::size_t far = 0;
  for (const Block& block : blocks_) {
    const double mean_m = double{mean_of_block(frame.depth_m, side_px_, block.x, block.y)};
    if (mean_m <= 0) continue;
    const double change = (mean_m - block.depth_m) * block.per_sigma;
    far += std::abs(change) > largest_change;
    changes_.push_back({&block, std::clamp(change, -largest_change, largest_change)});
  }
  if (changes_.size() < least_blocks) return 0;  // hardly anything that could be mixed
  if (static_cast<double>(far) > most_outliers * static_cast<double>(changes_.size())) return everything;
  Vector6 motion = Vector6::Zero();
  Matrix6 information = Matrix6::Zero();
  double used = 0, residual_squares = 0;
  for (int pass = 0; pass < 2; ++pass) {  // the second one without what does not move with the rest
    information.setZero();
    Vector6 sum = Vector6::Zero();
    double squares = 0;
    used = 0;
    for (const Change& change : changes_) {
      const Vector6 response = vector_of(change.block->response);
      if (pass > 0 && std::abs(change.sigmas - response.dot(motion)) > outlier) continue;
      information += response * response.transpose();
      sum += change.sigmas * response;
      squares += change.sigmas * change.sigmas;
      ++used;
    }
    motion = (information + stillness * Matrix6::Identity()).ldlt().solve(sum);
    residual_squares = squares - 2 * motion.dot(sum) + motion.dot(information * motion);
  }
  if (used < least_blocks) return everything;
  const double noise = noise_chi2 * std::max(0.0, residual_squares) / used;
  return std::sqrt(std::max(0.0, motion.dot(information * motion) - noise) / used);
}

}  // namespace facet
