#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "core/rigid_motion.hpp"
#include "dataset/text_table.hpp"

namespace facet {

/// The motion that a unit quaternion, up to 2 % off its length, and an origin describe; nothing for other
/// quaternions.
std::optional<RigidMotion> motion_from_quaternion(const std::array<double, 4>& xyzw, Vec3d origin);

/// The motion of a 4x4 matrix, row by row; nothing where its upper left is no rotation within 2 %.
std::optional<RigidMotion> motion_from_matrix(std::span<const double, 16> rows);

/// Poses of a camera over time.
class Trajectory {
 public:
  /// From lines `timestamp tx ty tz qx qy qz qw` (camera in the world), in any order; others are counted.
  explicit Trajectory(const std::vector<TextLine>& lines = {});

  /// The pose at a time, interpolated between its neighbours; nothing where one of these is farther away than
  /// `tolerance_s`, or outside the trajectory.
  std::optional<RigidMotion> at(double timestamp_s, double tolerance_s) const;
  std::size_t size() const { return poses_.size(); }
  std::size_t broken_lines() const { return broken_lines_; }

 private:
  struct TimedPose {
    double timestamp_s = 0;
    std::array<double, 4> xyzw{};
    Vec3d origin;
  };
  std::vector<TimedPose> poses_;
  std::size_t broken_lines_ = 0;
};

}  // namespace facet
