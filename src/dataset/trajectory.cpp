#include "dataset/trajectory.hpp"

#include <algorithm>
#include <cmath>

namespace facet {
namespace {

constexpr double rotation_tolerance = 0.02;

double inner(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

std::optional<std::array<double, 8>> eight_numbers(const TextLine& line) {
  if (line.size() != 8) return std::nullopt;
  std::array<double, 8> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = finite_number(line[i]);
    if (!number) return std::nullopt;
    numbers[i] = *number;
  }
  return numbers;
}

}  // namespace

std::optional<RigidMotion> motion_from_quaternion(const std::array<double, 4>& xyzw, Vec3d origin) {
  const double length = std::sqrt(inner(xyzw, xyzw));
  if (!(std::abs(length - 1) <= rotation_tolerance)) return std::nullopt;
  const double x = xyzw[0] / length, y = xyzw[1] / length, z = xyzw[2] / length, w = xyzw[3] / length;
  return RigidMotion{{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
                     {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
                     {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)},
                     origin};
}

std::optional<RigidMotion> motion_from_matrix(std::span<const double, 16> rows) {
  RigidMotion motion{{rows[0], rows[4], rows[8]},
                     {rows[1], rows[5], rows[9]},
                     {rows[2], rows[6], rows[10]},
                     {rows[3], rows[7], rows[11]}};
  const auto off = [](double value, double expected) {
    return !(std::abs(value - expected) <= rotation_tolerance);
  };
  if (off(norm(motion.ex), 1) || off(norm(motion.ey), 1) || off(dot(motion.ex, motion.ey), 0)) return {};
  motion.ex = normalized(motion.ex);
  const Vec3d ez = cross(motion.ex, motion.ey);
  if (!(norm(ez - motion.ez) <= rotation_tolerance)) return std::nullopt;
  motion.ez = normalized(ez);
  motion.ey = cross(motion.ez, motion.ex);
  return motion;
}

Trajectory::Trajectory(const std::vector<TextLine>& lines) {
  for (const TextLine& line : lines) {
    const auto n = eight_numbers(line);
    const bool whole = n && motion_from_quaternion({(*n)[4], (*n)[5], (*n)[6], (*n)[7]}, {}).has_value();
    if (whole)
      poses_.push_back({(*n)[0], {(*n)[4], (*n)[5], (*n)[6], (*n)[7]}, {(*n)[1], (*n)[2], (*n)[3]}});
    else
      ++broken_lines_;
  }
  std::stable_sort(poses_.begin(), poses_.end(),
                   [](const TimedPose& a, const TimedPose& b) { return a.timestamp_s < b.timestamp_s; });
}

std::optional<RigidMotion> Trajectory::at(double timestamp_s, double tolerance_s) const {
  const auto after =
      std::lower_bound(poses_.begin(), poses_.end(), timestamp_s,
                       [](const TimedPose& pose, double time) { return pose.timestamp_s < time; });
  if (after == poses_.end()) return std::nullopt;
  if (after->timestamp_s == timestamp_s) return motion_from_quaternion(after->xyzw, after->origin);
  if (after == poses_.begin()) return std::nullopt;
  const TimedPose &a = *std::prev(after), &b = *after;
  if (timestamp_s - a.timestamp_s > tolerance_s || b.timestamp_s - timestamp_s > tolerance_s) return {};
  const double share = (timestamp_s - a.timestamp_s) / (b.timestamp_s - a.timestamp_s);
  const double sign = inner(a.xyzw, b.xyzw) < 0 ? -1 : 1;  // q and -q are the same rotation
  std::array<double, 4> xyzw{};
  for (std::size_t i = 0; i < 4; ++i) xyzw[i] = (1 - share) * a.xyzw[i] + share * sign * b.xyzw[i];
  const double length = std::sqrt(inner(xyzw, xyzw));
  for (double& part : xyzw) part /= length;
  return motion_from_quaternion(xyzw, (1 - share) * a.origin + share * b.origin);
}

}  // namespace facet
