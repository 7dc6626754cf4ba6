#include "method/backend_agreement.hpp"

#include <algorithm>

#include "core/random.hpp"

namespace facet {
namespace {

constexpr Size size{160, 120};
constexpr Camera camera{131, 131, 79.5f, 59.5f};

Image<float> test_frame(std::uint64_t seed) {
  Image<float> depth_m(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const bool in_rows = y > 30 && y < 80;
      const float noise_m = 0.004f * random_uniform(seed, static_cast<std::uint64_t>(y), x) - 0.002f;
      const float table_m = 1 / (0.6f + 0.004f * static_cast<float>(y));
      const float box_m = 0.8f + 0.004f * static_cast<float>(std::abs(x - 70));  // two faces
      const float surface_m = in_rows && x > 45 && x < 95 ? box_m : table_m;
      const bool shadow = in_rows && x >= 95 && x < 101;
      depth_m(x, y) = shadow ? 0.0f : surface_m + noise_m;
    }
  return depth_m;
}

template <class T>
bool equal_images(const Image<T>& a, const Image<T>& b) {
  if (a.size() != b.size()) return false;
  for (int y = 0; y < a.height(); ++y)
    if (!std::equal(a.row(y), a.row(y) + a.width(), b.row(y))) return false;
  return true;
}

bool equal_surfaces(const Surface& a, const Surface& b) {
  if (a.area_px != b.area_px || a.contour.outer != b.contour.outer) return false;
  if (a.plane.has_value() != b.plane.has_value() || a.pose.has_value() != b.pose.has_value()) return false;
  if (a.plane && !(a.plane->normal == b.plane->normal && a.plane->d_m == b.plane->d_m)) return false;
  return !a.pose ||
         (a.pose->centre_m == b.pose->centre_m && a.pose->quaternion_wxyz == b.pose->quaternion_wxyz);
}

}  // namespace

bool agree_on_test_frames(Pipeline& one, Pipeline& other) {
  FrameResult a, b;
  for (const std::uint64_t seed : {1, 2}) {
    const Image<float> depth_m = test_frame(seed);
    one.process({depth_m.view(), camera}, a);
    other.process({depth_m.view(), camera}, b);
    if (!equal_images(a.labels, b.labels) || !equal_images(a.edges, b.edges)) return false;
    if (!std::equal(a.surfaces.begin(), a.surfaces.end(), b.surfaces.begin(), b.surfaces.end(),
                    equal_surfaces))
      return false;
  }
  return true;
}

}  // namespace facet
