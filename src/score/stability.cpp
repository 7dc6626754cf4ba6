#include "score/stability.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace facet {
namespace {

/// Pixels that only one of the frames sees.
constexpr std::uint16_t unseen = 0xffff;
/// Depths differ by less where both frames see the same point.
constexpr double same_depth_share = 0.05;
constexpr double found_again_iou = 0.5;

/// Pixels of every region and of every pair of regions of two label images.
struct Overlaps {
  std::map<int, int> before, now;
  std::map<std::pair<int, int>, int> both;  ///< by label before and now
};

Overlaps count_overlaps(const Image<std::uint16_t>& before, const Image<std::uint16_t>& now) {
  Overlaps counts;
  std::map<std::uint32_t, int> pairs;
  std::uint32_t last = 0;
  int run = 0;
  const auto flush = [&] {
    if (run > 0) pairs[last] += run;
    run = 0;
  };
  for (int y = 0; y < now.height(); ++y)
    for (int x = 0; x < now.width(); ++x) {
      if (before(x, y) == unseen) continue;
      const std::uint32_t pair = std::uint32_t{before(x, y)} << 16 | now(x, y);
      if (pair != last) flush();
      last = pair;
      ++run;
    }
  flush();
  for (const auto& [pair, count] : pairs) {
    const int a = static_cast<int>(pair >> 16), b = static_cast<int>(pair & 0xffff);
    if (a > 0) counts.before[a] += count;
    if (b > 0) counts.now[b] += count;
    if (a > 0 && b > 0) counts.both[{a, b}] = count;
  }
  const auto small = [](const auto& region) { return region.second < StabilityTracker::least_region_px; };
  std::erase_if(counts.before, small);
  std::erase_if(counts.now, small);
  std::erase_if(counts.both, [&](const auto& pair) {
    return !counts.before.contains(pair.first.first) || !counts.now.contains(pair.first.second);
  });
  return counts;
}

/// The best partner of every region, and how well it fits.
struct Partners {
  std::map<int, double> best_before, best_now;
  std::map<int, int> same;  ///< label now -> label before, where above found_again_iou: at most one then
};

Partners find_partners(const Overlaps& counts) {
  Partners partners;
  for (const auto& [labels, shared] : counts.both) {
    const auto [a, b] = labels;
    const double iou = static_cast<double>(shared) / (counts.before.at(a) + counts.now.at(b) - shared);
    partners.best_before[a] = std::max(partners.best_before[a], iou);
    partners.best_now[b] = std::max(partners.best_now[b], iou);
    if (iou > found_again_iou) partners.same[b] = a;
  }
  return partners;
}

void add_agreement(const std::map<int, int>& areas, const std::map<int, double>& best, FrameStability& row) {
  for (const auto& [label, area] : areas) {
    const auto found = best.find(label);
    const double iou = found == best.end() ? 0 : found->second;
    row.iou_sum += iou;
    row.covered_px += iou * area;
    row.region_px += area;
    ++row.regions;
  }
}

Vec3d to_double(Vec3 v) {
  return {double{v.x}, double{v.y}, double{v.z}};
}

}  // namespace

FrameStability StabilityTracker::next(const StabilityInput& frame) {
  FrameStability row;
  row.in_world = frame.T_world_camera && (!before_ || before_->T_world_camera);
  const Image<std::uint16_t>& labels = frame.prediction.labels;
  const bool comparable = before_ && before_->labels.size() == labels.size();
  Partners partners;
  if (comparable) {
    const Overlaps counts = count_overlaps(labels_before_seen_from(frame, row.in_world), labels);
    partners = find_partners(counts);
    row.compared = true;
    add_agreement(counts.before, partners.best_before, row);
    add_agreement(counts.now, partners.best_now, row);
    row.before = static_cast<int>(counts.before.size());
    row.kept = static_cast<int>(partners.same.size());
  }
  std::vector<int> tracks(0x10000);
  for (const Surface& surface : frame.prediction.surfaces) {
    const auto same = partners.same.find(surface.id);
    int& track = tracks[static_cast<std::size_t>(surface.id)];
    track =
        same == partners.same.end() ? next_track_++ : before_->tracks[static_cast<std::size_t>(same->second)];
    if (!surface.pose || !surface.plane || surface.curved) continue;
    const Vec3d normal = to_double(surface.plane->normal), centre = to_double(surface.pose->centre_m);
    if (row.in_world)
      row.planes.push_back(
          {track, frame.T_world_camera->rotate(normal), frame.T_world_camera->apply(centre)});
    else
      row.planes.push_back({track, normal, centre});
  }
  Image<float> depth_m(frame.depth_m.size());
  for (int y = 0; y < depth_m.height(); ++y)
    std::copy_n(frame.depth_m.row(y), depth_m.width(), depth_m.row(y));
  before_ = {labels, std::move(depth_m), frame.camera, frame.T_world_camera, std::move(tracks)};
  return row;
}

/// The labels of the frame before as this frame's camera sees them; without poses they stay where they are.
Image<std::uint16_t> StabilityTracker::labels_before_seen_from(const StabilityInput& frame,
                                                               bool in_world) const {
  if (!in_world) return before_->labels;
  Image<std::uint16_t> seen(before_->labels.size(), unseen);
  const RigidMotion T_before_now = before_->T_world_camera->inverse() * *frame.T_world_camera;
  const Camera& camera = before_->camera;
  for (int y = 0; y < seen.height(); ++y)
    for (int x = 0; x < seen.width(); ++x) {
      const float depth_m = frame.depth_m(x, y);
      if (depth_m <= 0) continue;
      const Vec3d p = T_before_now.apply(
          to_double(frame.camera.back_project(static_cast<float>(x), static_cast<float>(y), depth_m)));
      if (p.z <= 0) continue;
      const double u = std::floor(p.x / p.z * double{camera.fx} + double{camera.cx} + 0.5);
      const double v = std::floor(p.y / p.z * double{camera.fy} + double{camera.cy} + 0.5);
      if (!(u >= 0 && v >= 0 && u < seen.width() && v < seen.height())) continue;
      const int i = static_cast<int>(u), k = static_cast<int>(v);
      const double there_m = double{before_->depth_m(i, k)};
      if (there_m > 0 && std::abs(there_m - p.z) <= same_depth_share * p.z)
        seen(x, y) = before_->labels(i, k);
    }
  return seen;
}

}  // namespace facet
