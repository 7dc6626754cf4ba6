#include "surface/support.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/angle.hpp"
#include "core/run.hpp"
#include "surface/plane_frame.hpp"

namespace facet {
namespace {

/// A smaller share of all labelled pixels supports nothing worth the fit of a plane.
constexpr double min_share = 0.05;

bool leans_too_far(const Plane& plane, float max_tilt_deg) {
  return -plane.normal.y < std::cos(max_tilt_deg / degrees_per_radian);
}

/// Distance from `plane` of the plane through the points: root mean square over the points [m].
struct Offset {
  double rms_m = 0;
  double depth_m = 0;  ///< mean
  double facing = 0;   ///< mean of |n . ray| for rays of unit depth: share of a change of depth that shows
};
Offset offset_of(const PointSample& points, const Plane& plane, const Camera& camera) {
  const auto n = static_cast<double>(points.size());
  // Distances as an affine function of two coordinates in the plane: exact for planes.
  const PlaneFrame frame(plane, camera, points.at(0));
  double x = 0, y = 0, r = 0, xx = 0, xy = 0, yy = 0, xr = 0, yr = 0;
  Offset offset;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 p = points.at(i);
    const auto [px, py] = frame.from_space(p);
    const double pr = plane.signed_distance_m(p);
    x += px, y += py, r += pr;
    xx += px * px, xy += px * py, yy += py * py, xr += px * pr, yr += py * pr;
    offset.depth_m += p.z / n;
    offset.facing += std::fabs(dot(plane.normal, p)) / p.z / n;
  }
  xx -= x * x / n, xy -= x * y / n, yy -= y * y / n, xr -= x * r / n, yr -= y * r / n;
  const double det = xx * yy - xy * xy;
  const bool flat = det > 1e-9 * xx * yy;  // points on a line tell no slope across it
  const double sx = flat ? (yy * xr - xy * yr) / det : 0, sy = flat ? (xx * yr - xy * xr) / det : 0;
  const double varied = (sx * sx * xx + 2 * sx * sy * xy + sy * sy * yy) / n;
  offset.rms_m = std::sqrt(r * r / (n * n) + varied);
  return offset;
}

}  // namespace

int Support::label_in(ImageView<const std::uint16_t> labels) const {
  return plane_ ? labels(place_ % labels.width, place_ / labels.width) : 0;
}

/// Whether the neighbours that touch it rise from it rather than fall away.
bool Support::is_supporting(const SupportInput& input, int label) const {
  int rising_px = 0, falling_px = 0;
  for (const SurfaceBorder& border : borders_.all()) {
    if (border.a != label && border.b != label) continue;
    const int other = border.a == label ? border.b : border.a;
    const PointSample& points = input.pixels.points[static_cast<std::size_t>(other) - 1];
    (lies_in_front(points, *plane_) ? rising_px : falling_px) += border.crease_px();
  }
  return rising_px > falling_px;
}

void Support::find(const SupportInput& input, const SupportParams& params) {
  const std::vector<int>& area_px = input.pixels.area_px;
  const auto area_of = [&](int label) { return area_px[static_cast<std::size_t>(label) - 1]; };
  by_area_.resize(area_px.size());
  std::iota(by_area_.begin(), by_area_.end(), 1);
  std::sort(by_area_.begin(), by_area_.end(),
            [&](int a, int b) { return area_of(a) != area_of(b) ? area_of(a) > area_of(b) : a < b; });
  const double least_px = min_share * std::accumulate(area_px.begin(), area_px.end(), 0.0);
  for (const int label : by_area_) {
    if (area_of(label) < least_px) break;
    const PointSample& points = input.pixels.points[static_cast<std::size_t>(label) - 1];
    if (points.size() == 0) continue;
    const float threshold_m = plane_threshold_m(points, input.pose, input.noise);
    plane_ = fit_plane(points, input.pose, threshold_m, input.seed, static_cast<std::uint64_t>(label)).plane;
    label_ = label;
    if (plane_ && !leans_too_far(*plane_, params.max_tilt_deg) && is_supporting(input, label)) return;
  }
  plane_.reset();
}

void Support::find_pieces(const SupportInput& input, const SupportParams& params) {
  count_ = 0;
  for (std::size_t i = 0; i < input.pixels.area_px.size(); ++i) {
    const PointSample& points = input.pixels.points[i];
    const bool is_support = static_cast<int>(i) + 1 == label_;
    bool joins = false;
    if (!is_support && points.size() > 2) {
      const Offset offset = offset_of(points, *plane_, input.camera);
      const double readings =
          std::max(input.pixels.measured_px[i] / double{input.noise.pixels_per_reading}, 1.0);
      // A fit of three parameters knows its own points to sqrt(3 / readings) of one reading's noise.
      const double noise_m =
          offset.facing * input.noise.sigma_m(static_cast<float>(offset.depth_m)) * std::sqrt(3 / readings);
      const double limit_m =
          params.flatness_mm / 1000 * offset.depth_m * offset.depth_m + params.noise_sigmas * noise_m;
      joins = offset.rms_m <= limit_m;
    }
    new_label_[i + 1] = joins ? 0 : static_cast<std::uint16_t>(++count_);
  }
  const std::uint16_t support = new_label_[static_cast<std::size_t>(label_)];
  std::replace(new_label_.begin() + 1, new_label_.end(), std::uint16_t{0}, support);
}

int Support::unite(const SupportInput& input, const SupportParams& params) {
  const int count = static_cast<int>(input.pixels.area_px.size());
  plane_.reset();
  borders_.collect(input.labels, input.edges, count);
  find(input, params);
  if (!plane_) return count;
  const PixelBox& box = input.pixels.boxes[static_cast<std::size_t>(label_) - 1];
  const std::uint16_t* row = input.labels.row(box.y0);
  place_ =
      box.y0 * input.labels.width + static_cast<int>(std::find(row, row + input.labels.width, label_) - row);
  new_label_.assign(static_cast<std::size_t>(count) + 1, 0);
  find_pieces(input, params);
  if (count_ < count) relabel(input);
  return count_;
}

/// A crease whose both sides are the support's has pieces of it around it, and nothing else.
void Support::relabel(const SupportInput& input) {
  const ImageView<std::uint16_t> labels = input.labels;
  const std::uint16_t support = new_label_[static_cast<std::size_t>(label_)];
  const auto parts_only_support = [&](int x, int y) {
    bool parts = false;
    for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, labels.height - 1); ++ny)
      for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, labels.width - 1); ++nx) {
        if (labels(nx, ny) == 0 || new_label_[labels(nx, ny)] != support) return false;
        parts = parts || labels(nx, ny) != labels(x, y);
      }
    return parts;
  };
  for (int y = 0; y < labels.height; ++y) {
    std::uint8_t* edges = input.edges.row(y);
    const auto next_edge = [&](int x) { return end_of_run<std::uint8_t>(edges, x, labels.width, 0); };
    for (int x = next_edge(0); x < labels.width; x = next_edge(x + 1)) {
      const auto kind = edge_kind_of(edges[x]);
      if ((kind == EdgeKind::convex || kind == EdgeKind::concave) && parts_only_support(x, y)) edges[x] = 0;
    }
  }
  for (int y = 0; y < labels.height; ++y) {
    std::uint16_t* row = labels.row(y);
    for (int begin = 0, end = 0; begin < labels.width; begin = end) {
      end = end_of_run(row, begin, labels.width, row[begin]);
      if (const std::uint16_t label = new_label_[row[begin]]; label != row[begin])
        std::fill(row + begin, row + end, label);
    }
  }
}

}  // namespace facet
