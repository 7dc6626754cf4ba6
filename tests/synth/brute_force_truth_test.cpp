// The truth derived from curves in space against a plain recomputation from a rendering of four times the
// resolution.
#include <gtest/gtest.h>
#include <map>

#include "synth/families.hpp"

namespace facet {
namespace {

constexpr int factor = 4;
constexpr Size size{320, 240};
constexpr Camera camera{262.5f, 262.5f, 159.5f, 119.5f};
constexpr Size fine_size{factor * size.width, factor* size.height};
constexpr Camera fine_camera{factor * camera.fx, factor* camera.fy, factor*(camera.cx + 0.5f) - 0.5f,
                             factor*(camera.cy + 0.5f) - 0.5f};

/// Which edge a place belongs to: owner and kind.
using EdgeClass = std::pair<int, EdgeKind>;

/// Places that lie within `radius` fine pixels of something, by class.
class NearMap {
 public:
  explicit NearMap(int radius) : radius_(radius) {}
  void add(EdgeClass c, double x, double y) {
    auto [place, is_new] = maps_.try_emplace(c);
    if (is_new) place->second = Image<std::uint8_t>(fine_size, 0);
    const int cx = static_cast<int>(std::lround(x)), cy = static_cast<int>(std::lround(y));
    for (int dy = -radius_; dy <= radius_; ++dy) {
      for (int dx = -radius_; dx <= radius_; ++dx) {
        if (fine_size.contains(cx + dx, cy + dy)) place->second(cx + dx, cy + dy) = 1;
      }
    }
  }
  bool near(EdgeClass c, double x, double y) const {
    const auto place = maps_.find(c);
    const int cx = static_cast<int>(std::lround(x)), cy = static_cast<int>(std::lround(y));
    return place != maps_.end() && fine_size.contains(cx, cy) && place->second(cx, cy) != 0;
  }

 private:
  int radius_;
  std::map<EdgeClass, Image<std::uint8_t>> maps_;
};

struct Crack {
  EdgeClass edge;
  double x, y;
  bool certain;  ///< clearly of this class: worth asking whether the truth has it
};

/// Step in depth from the surface at one pixel to that at another, each continued to the other's pixel.
double step_between(const Rendering& image, int ax, int ay, int bx, int by) {
  const auto continued = [&](int x, int y, int to_x, int to_y) {
    const Vec3 n = image.normals(x, y);
    const auto ray = [](int u, int v) {
      return fine_camera.back_project(static_cast<float>(u), static_cast<float>(v), 1);
    };
    const double towards = dot(n, ray(to_x, to_y));
    return towards < -1e-3 ? image.depth_m(x, y) * dot(n, ray(x, y)) / towards : 1e9;
  };
  const double z_a = image.depth_m(ax, ay), z_b = image.depth_m(bx, by);
  return std::min(std::abs(continued(ax, ay, bx, by) - z_b), std::abs(continued(bx, by, ax, ay) - z_a));
}

void collect_crack(const Rendering& image, int ax, int ay, int bx, int by, std::vector<Crack>& cracks) {
  if (image.surface_ids(ax, ay) == image.surface_ids(bx, by) && image.object_ids(ax, ay) == 0) return;
  const double step = step_between(image, ax, ay, bx, by), x = 0.5 * (ax + bx), y = 0.5 * (ay + by);
  const bool a_nearer = image.depth_m(ax, ay) < image.depth_m(bx, by);
  const int near_object = a_nearer ? image.object_ids(ax, ay) : image.object_ids(bx, by);
  const double turn = dot(image.normals(ax, ay), image.normals(bx, by));
  const bool same_face = image.surface_ids(ax, ay) == image.surface_ids(bx, by);
  const double gap = std::abs(image.depth_m(ax, ay) - image.depth_m(bx, by));
  if (near_object > 0 && step > 0.0015 && gap > 0.0015) {
    cracks.push_back({{near_object, EdgeKind::depth}, x, y, step > 0.012 && gap > 0.02});
  }
  if (same_face || step > 0.006) return;
  const auto point = [&](int px, int py) {
    return fine_camera.back_project(static_cast<float>(px), static_cast<float>(py), image.depth_m(px, py));
  };
  const float bend = dot(point(bx, by) - point(ax, ay), image.normals(bx, by) - image.normals(ax, ay));
  const EdgeKind kind = bend > 0 ? EdgeKind::convex : EdgeKind::concave;
  const bool one_object = image.object_ids(ax, ay) == image.object_ids(bx, by);
  for (const int object : {image.object_ids(ax, ay), image.object_ids(bx, by)}) {
    if (object > 0) cracks.push_back({{object, kind}, x, y, one_object && step < 0.0005 && turn < 0.95});
  }
}

std::vector<Crack> cracks_of(const Rendering& image) {
  std::vector<Crack> cracks;
  for (int y = 0; y + 1 < fine_size.height; ++y) {
    for (int x = 0; x + 1 < fine_size.width; ++x) {
      collect_crack(image, x, y, x + 1, y, cracks);
      collect_crack(image, x, y, x, y + 1, cracks);
    }
  }
  return cracks;
}

struct Agreement {
  int truth_points = 0, truth_confirmed = 0, cracks = 0, cracks_explained = 0;
};

void compare(const View& view, Agreement& sum) {
  const PosedScene posed(view.scene, view.T_world_camera);
  const auto edges = true_edges(view.scene, view.T_world_camera, posed, camera, size);
  const auto cracks = cracks_of(render(posed, fine_camera, fine_size));
  const auto fine = [](double v) { return factor * (v + 0.5) - 0.5; };
  NearMap seen(2), known(3);  // half and three quarters of a pixel
  for (const Crack& crack : cracks) seen.add(crack.edge, crack.x, crack.y);
  for (const TrueEdge& edge : edges) {
    const EdgeClass c{edge.object_id, edge.kind};
    for (std::size_t i = 1; i < edge.line.size(); ++i) {
      const ImagePoint a = edge.line[i - 1], b = edge.line[i];
      for (const double t : {0.0, 0.25, 0.5, 0.75})
        known.add(c, fine(a.x + t * (b.x - a.x)), fine(a.y + t * (b.y - a.y)));
      if (edge.length_px < 4 || i < 2 || i + 2 > edge.line.size()) continue;
      ++sum.truth_points;
      sum.truth_confirmed += seen.near(c, fine(a.x), fine(a.y));
    }
  }
  for (const Crack& crack : cracks) {
    if (!crack.certain) continue;
    ++sum.cracks;
    sum.cracks_explained += known.near(crack.edge, crack.x, crack.y);
  }
}

TEST(BruteForceTruth, EdgesOfFiftyRandomScenesAreThoseOfTheirFineRendering) {
  Agreement sum;
  const auto& families = scene_families();
  for (std::uint64_t k = 0; k < 50; ++k) {
    compare(random_layout(families[k % families.size()], 77, k, camera, size).view, sum);
  }
  ASSERT_GT(sum.truth_points, 20000);
  ASSERT_GT(sum.cracks, 100000);
  EXPECT_GT(sum.truth_confirmed, 0.99 * sum.truth_points)
      << sum.truth_confirmed << " of " << sum.truth_points;
  EXPECT_GT(sum.cracks_explained, 0.99 * sum.cracks) << sum.cracks_explained << " of " << sum.cracks;
}

TEST(BruteForceTruth, FacesOfFiftyRandomScenesHaveTheAreasCentroidsAndPlanesOfTheirPixels) {
  const auto& families = scene_families();
  for (std::uint64_t k = 0; k < 50; ++k) {
    const View view = random_layout(families[k % families.size()], 78, k, camera, size).view;
    const PosedScene posed(view.scene, view.T_world_camera);
    const SceneTruth truth = scene_truth(view, posed, render(posed, camera, size), camera);
    std::map<int, std::pair<int, Vec3d>> sums;
    std::map<int, double> farthest_off;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const auto hit = posed.cast(camera, x, y);
        if (!hit || hit->object_id == 0) continue;
        auto& [count, point] = sums[hit->surface_id];
        ++count;
        point = point + hit->point;
      }
    }
    ASSERT_EQ(truth.faces.size(), sums.size());
    for (const TrueFace& face : truth.faces) {
      const auto& [count, point] = sums[face.surface_id];
      EXPECT_EQ(face.visible_px, count);
      const Vec3 centroid = to_float((1.0 / count) * point);
      EXPECT_LT(norm(face.centroid_m - centroid), 1e-5);
      ASSERT_EQ(face.plane.has_value(), !face.curved);
      if (!face.plane) continue;
      EXPECT_NEAR(face.plane->signed_distance_m(centroid), 0, 1e-5);
      EXPECT_GT(face.plane->d_m, 0);
      EXPECT_NEAR(norm(face.plane->normal), 1, 1e-5);
    }
  }
}

}  // namespace
}  // namespace facet
