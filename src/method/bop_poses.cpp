#include "method/bop_poses.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "method/frame_names.hpp"

namespace facet {
namespace {

constexpr const char* header = "scene_id,im_id,obj_id,score,R,t,time";

/// One line of the file; its accessors say where something is wrong.
class Line {
 public:
  Line(const std::filesystem::path& file, int number, const std::string& text)
      : file_(file), number_(number) {
    std::istringstream input(text);
    for (std::string field; std::getline(input, field, ',');) fields_.push_back(field);
    if (fields_.size() != 7 && fields_.size() != 6)
      fail(fmt::format("{} fields, expected {}", fields_.size(), header));
  }
  [[noreturn]] void fail(const std::string& rule) const {
    throw Error(ErrorKind::data, fmt::format("{}:{}: {}", printable(file_), number_, rule));
  }
  int number() const { return number_; }
  int integer(std::size_t i) const {
    const double value = numbers<1>(i)[0];
    if (value != std::floor(value) || std::abs(value) > 1e9) fail("'" + fields_[i] + "' is no whole number");
    return static_cast<int>(value);
  }
  template <std::size_t n>
  std::array<double, n> numbers(std::size_t i) const {
    std::istringstream input(fields_[i]);
    std::array<double, n> values{};
    std::size_t count = 0;
    for (std::string word; input >> word; ++count) {
      if (count == n) break;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), values[count]);
      if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(values[count]))
        fail("'" + word + "' is no number");
    }
    std::string rest;
    if (count != n || input >> rest) fail(fmt::format("'{}': expected {} numbers", fields_[i], n));
    return values;
  }

 private:
  std::filesystem::path file_;
  int number_;
  std::vector<std::string> fields_;
};

SurfacePose pose_of(const Line& line) {
  const auto r = line.numbers<9>(4);
  const auto t = line.numbers<3>(5);
  Eigen::Matrix3d rotation;
  rotation << r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8];
  constexpr double tolerance = 1e-3;
  const bool orthonormal =
      (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < tolerance;
  if (!orthonormal || rotation.determinant() < 0) line.fail("R is no rotation");
  Eigen::Quaterniond q(rotation);
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const auto degrees = [](double rad) { return static_cast<float>(rad * 180 / M_PI); };
  SurfacePose pose;
  pose.centre_m = {static_cast<float>(t[0] / 1000), static_cast<float>(t[1] / 1000),
                   static_cast<float>(t[2] / 1000)};
  pose.quaternion_wxyz = {static_cast<float>(q.w()), static_cast<float>(q.x()), static_cast<float>(q.y()),
                          static_cast<float>(q.z())};
  pose.zyx_deg = {degrees(std::atan2(r[3], r[0])), degrees(-std::asin(std::clamp(r[6], -1.0, 1.0))),
                  degrees(std::atan2(r[7], r[8]))};
  pose.rect_axis = {static_cast<float>(r[0]), static_cast<float>(r[3]), static_cast<float>(r[6])};
  return pose;
}

}  // namespace

std::map<std::string, std::vector<BopPose>> read_bop_poses(const std::filesystem::path& file,
                                                           const std::string& frame_id) {
  std::ifstream input(file);
  if (!input) throw Error(ErrorKind::data, printable(file) + ": is missing or cannot be read");
  std::map<std::string, std::vector<BopPose>> poses;
  std::string text;
  for (int number = 1; std::getline(input, text); ++number) {
    if (!text.empty() && text.back() == '\r') text.pop_back();
    if (text.empty() || (number == 1 && text == header)) continue;
    const Line line(file, number, text);
    const std::string frame = frame_named(frame_id, line.integer(0), line.integer(1));
    poses[frame].push_back({number, line.integer(2), line.numbers<1>(3)[0], pose_of(line)});
  }
  return poses;
}

void apply_poses(const std::filesystem::path& file, const std::vector<BopPose>& poses,
                 std::vector<Surface>& surfaces) {
  std::map<int, double> best;
  for (const BopPose& pose : poses) {
    const auto surface = std::find_if(surfaces.begin(), surfaces.end(),
                                      [&](const Surface& s) { return s.id == pose.surface; });
    if (surface == surfaces.end())
      throw Error(ErrorKind::data, fmt::format("{}:{}: obj_id {} is no label of the frame's label image",
                                               printable(file), pose.line, pose.surface));
    const auto [known, is_first] = best.try_emplace(pose.surface, pose.score);
    if (!is_first && pose.score <= known->second) continue;
    known->second = pose.score;
    surface->pose = pose.pose;
    surface->no_pose_reason.clear();
  }
}

}  // namespace facet
