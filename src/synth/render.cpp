#include "synth/render.hpp"

#include <algorithm>

#include "synth/intersect.hpp"

namespace facet {
namespace {

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct PixelBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// Pixels that may see the patch; the whole image where it reaches behind the camera.
PixelBox pixel_box(const Patch& patch, const Camera& camera, Size size) {
  constexpr double nearest_m = 0.01;
  double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
  for (const Vec3d& p : bounding_corners(patch)) {
    if (p.z < nearest_m) return {0, 0, size.width, size.height};
    const double x = camera.fx * p.x / p.z + camera.cx, y = camera.fy * p.y / p.z + camera.cy;
    x0 = std::min(x0, x), x1 = std::max(x1, x);
    y0 = std::min(y0, y), y1 = std::max(y1, y);
  }
  const auto clip = [](double v, int end) {
    return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(end)));
  };
  return {clip(std::floor(x0), size.width), clip(std::floor(y0), size.height),
          clip(std::ceil(x1) + 1, size.width), clip(std::ceil(y1) + 1, size.height)};
}

/// What was seen last at a pixel: patch index + 1, negative where it was its back.
using HitImage = Image<std::int32_t>;

void draw_patch(const PosedPatch& posed, int index, const Camera& camera, Image<double>& depth,
                HitImage& hits) {
  const RigidMotion& frame = posed.patch.frame;
  const Vec3d origin = frame.unapply({});
  const PixelBox box = pixel_box(posed.patch, camera, depth.size());
  const Vec3d step = frame.unrotate({1.0 / camera.fx, 0, 0});
  for (int y = box.y0; y < box.y1; ++y) {
    const Vec3d first = frame.unrotate(ray_direction(camera, 0, y));
    double* depth_row = depth.row(y);
    for (int x = box.x0; x < box.x1; ++x) {
      const auto hit = intersect(posed.patch, origin, first + static_cast<double>(x) * step, depth_row[x]);
      if (!hit) continue;
      depth_row[x] = hit->distance;
      hits(x, y) = hit->front ? index + 1 : -(index + 1);
    }
  }
}

/// Lambertian under a lamp above the left shoulder of the camera.
Rgb shade(Rgb colour, Vec3d normal) {
  static const Vec3d lamp = normalized(Vec3d{-0.45, -0.75, -0.6});
  const double light = 0.4 + 0.6 * std::max(0.0, dot(normal, lamp));
  const auto scaled = [light](std::uint8_t v) { return static_cast<std::uint8_t>(v * light + 0.5); };
  return {scaled(colour.r), scaled(colour.g), scaled(colour.b)};
}

void resolve_pixel(const PosedPatch& posed, bool front, Vec3d point, int x, int y, Rendering& out) {
  const RigidMotion& frame = posed.patch.frame;
  const Vec3d outward = frame.rotate(front_normal(posed.patch, frame.unapply(point)));
  const Vec3d normal = front ? outward : -outward;
  out.depth_m(x, y) = static_cast<float>(point.z);
  out.surface_ids(x, y) = front ? posed.front_id : posed.back_id;
  out.object_ids(x, y) = posed.object_id;
  out.normals(x, y) = to_float(normal);
  out.colour(x, y) = shade(posed.colour, normal);
}

}  // namespace

Rendering render(const PosedScene& scene, const Camera& camera, Size size) {
  Image<double> depth(size, 1e9);
  HitImage hits(size);
  const auto& patches = scene.patches();
  for (std::size_t k = 0; k < patches.size(); ++k)
    draw_patch(patches[k], static_cast<int>(k), camera, depth, hits);

  Rendering out{Image<float>(size), Image<std::uint16_t>(size), Image<std::uint16_t>(size), Image<Vec3>(size),
                Image<Rgb>(size)};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const std::int32_t hit = hits(x, y);
      if (hit == 0) continue;
      resolve_pixel(patches[std::abs(hit) - 1], hit > 0, depth(x, y) * ray_direction(camera, x, y), x, y,
                    out);
    }
  }
  return out;
}

}  // namespace facet
