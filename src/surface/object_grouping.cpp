#include "surface/object_grouping.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "surface/patch_fit.hpp"

namespace facet {
namespace {

/// Fewer pixels of a crease are the corner of two other borders.
constexpr int min_crease_px = 4;
/// The curvature of a hollow [1/m]: cups and bowls have radii below 25 cm, and about the same inside and
/// outside.
constexpr float least_curvature_per_m = 4;
constexpr float most_curvature_ratio = 2;
/// Least share of a hollow's border along which its own outside hides part of it; about half where the rim is
/// an ellipse.
constexpr double min_outside_share = 0.2;

double mean_depth_m(const PointSample& points) {
  return std::accumulate(points.z.begin(), points.z.end(), 0.0) / static_cast<double>(points.size());
}

/// Walls and floor.
bool is_background(const ObjectInput& input, const ObjectParams& params, const Surface& surface) {
  if (surface.id == input.support) return true;
  const PointSample& points = input.points[static_cast<std::size_t>(surface.id) - 1];
  if (!surface.touches_border || points.size() == 0) return false;
  const double depth_m = mean_depth_m(points), side_px = params.max_size_mm / 1000 / depth_m;
  if (surface.area_px > side_px * side_px * input.camera.fx * input.camera.fy) return true;
  return input.support_plane && lies_in_front(points, reversed(*input.support_plane));
}

/// Sum of the curvatures in the image's directions [1/m] of a patch fitted to the points, positive where it
/// is hollow towards the camera. A sphere of radius r seen from the front has q'' = -1 / (focal length
/// squared times r) in both directions.
double curvature_per_m(const PointSample& points, const Camera& camera) {
  constexpr std::size_t enough = 128;
  const std::size_t stride = points.size() / enough + 1;
  PatchMoments moments;
  double x_px = 0, y_px = 0;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const double x = points.x[i] / points.z[i] * camera.fx, y = points.y[i] / points.z[i] * camera.fy;
    moments.add_run(x, y, 1, [&](int) { return 1.0 / points.z[i]; });
    x_px += x, y_px += y;
  }
  if (moments.count() < 6) return 0;
  x_px /= moments.count(), y_px /= moments.count();
  const double q = moments.mean_q(), squared_focal = double{camera.fx} * camera.fy;
  // A weak prior: two millimetres of noise, any slope, the radius of a small cup.
  const double sigma_q = 0.002 * q * q;
  const PatchFit fit = moments.fit({sigma_q * sigma_q, q / 100, 1 / (squared_focal * 0.02)});
  constexpr double step_px = 1;
  return squared_focal / (2 * step_px) *
         (fit.at(x_px + step_px, y_px).qx - fit.at(x_px - step_px, y_px).qx +
          fit.at(x_px, y_px + step_px).qy - fit.at(x_px, y_px - step_px).qy);
}

bool is_convex(const SurfaceBorder& border, const ObjectParams& params) {
  const auto creases = static_cast<float>(border.crease_px());
  return border.crease_px() >= min_crease_px &&
         creases >= params.min_crease_share * static_cast<float>(border.length_px()) &&
         static_cast<float>(border.convex_px) >= params.min_convex_share * creases;
}

}  // namespace

void ObjectGrouping::describe(const ObjectInput& input, const ObjectParams& params,
                              const std::vector<Surface>& surfaces) {
  faces_.assign(surfaces.size(), {});
  for (const Surface& surface : surfaces) {
    Face& f = face(surface.id);
    f.is_background = is_background(input, params, surface);
    f.is_curved = surface.curved;
    if (params.hollow && !f.is_background)
      f.curvature_per_m = static_cast<float>(
          curvature_per_m(input.points[static_cast<std::size_t>(surface.id) - 1], input.camera));
  }
}

void ObjectGrouping::join_convex(const ObjectParams& params) {
  for (const SurfaceBorder& border : borders_.all()) {
    if (face(border.a).is_background || face(border.b).is_background) continue;
    if (is_convex(border, params)) objects_.join(border.a, border.b);
  }
}

/// The inside of a cup is hidden in part by the outside below its near rim.
void ObjectGrouping::join_hollow() {
  const auto consider = [&](int inside, int outside, int hidden_px, int length_px) {
    Face& f = face(inside);
    f.border_px += length_px;
    if (f.is_background || face(outside).is_background || hidden_px <= f.outside_px) return;
    const float out = -face(outside).curvature_per_m, in = f.curvature_per_m;
    if (!f.is_curved || std::min(in, out) < least_curvature_per_m || in > most_curvature_ratio * out) return;
    f.outside_px = hidden_px;
    f.outside = outside;
  };
  for (const SurfaceBorder& border : borders_.all()) {
    consider(border.a, border.b, border.b_nearer_px, border.length_px());
    consider(border.b, border.a, border.a_nearer_px, border.length_px());
  }
  for (std::size_t i = 0; i < faces_.size(); ++i)
    if (faces_[i].outside > 0 && faces_[i].outside_px >= min_outside_share * faces_[i].border_px)
      objects_.join(static_cast<int>(i) + 1, faces_[i].outside);
}

void ObjectGrouping::group(const ObjectInput& input, const ObjectParams& params,
                           std::vector<Surface>& surfaces) {
  borders_.collect(input.labels, input.edges, static_cast<int>(surfaces.size()));
  objects_.reset(static_cast<int>(surfaces.size()) + 1);
  describe(input, params, surfaces);
  join_convex(params);
  if (params.hollow) join_hollow();
  for (Surface& surface : surfaces)
    surface.object = face(surface.id).is_background ? 0 : objects_.find(surface.id);
}

}  // namespace facet
