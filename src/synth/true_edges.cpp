#include "synth/true_edges.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "synth/silhouette.hpp"

namespace facet {
namespace {

/// A curve in the camera frame with the posed patches it belongs to.
struct OwnedCurve {
  Curve curve;
  std::uint16_t object_id = 0;
  std::size_t patch_a = 0, patch_b = 0;
  bool silhouette = false;
};

std::vector<OwnedCurve> curves_of(const Scene& scene, const RigidMotion& T_camera_world) {
  std::vector<OwnedCurve> out;
  std::size_t first_patch = 0;
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    const SceneObject& object = scene.objects[k];
    const RigidMotion T_camera_object = T_camera_world * object.pose;
    const Vec3d eye = T_camera_object.inverse().origin;
    std::vector<Curve> curves = object.curves;
    for (std::size_t p = 0; p < object.patches.size(); ++p) {
      const auto more = silhouettes(object.patches[p], eye, static_cast<int>(p));
      curves.insert(curves.end(), more.begin(), more.end());
    }
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const Curve& curve = curves[c];
      const std::size_t a = first_patch + curve.patch_a;
      const std::size_t b = curve.patch_b < 0 ? a : first_patch + curve.patch_b;
      const bool silhouette = c >= object.curves.size();
      out.push_back({curve.moved(T_camera_object), static_cast<std::uint16_t>(k + 1), a, b, silhouette});
    }
    first_patch += object.patches.size();
  }
  return out;
}

std::optional<ImagePoint> picture_of(const Camera& camera, Vec3d p) {
  if (p.z < 0.01) return {};
  return ImagePoint{camera.fx * p.x / p.z + camera.cx, camera.fy * p.y / p.z + camera.cy};
}

double distance(ImagePoint a, ImagePoint b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// Length of the curve's picture, by 32 chords; 0 where part of it lies behind the camera.
double picture_length(const Curve& curve, const Camera& camera) {
  constexpr int chords = 32;
  double length = 0;
  std::optional<ImagePoint> last = picture_of(camera, curve.at(0));
  for (int k = 1; k <= chords; ++k) {
    const auto next = picture_of(camera, curve.at(static_cast<double>(k) / chords));
    if (!last || !next) return 0;
    length += distance(*last, *next);
    last = next;
  }
  return length;
}

struct WalkedPoint {
  Vec3d point, direction;  ///< on the curve, and along it
  ImagePoint image;
  EdgeSample sample;
};

WalkedPoint walk_to(const OwnedCurve& owned, double u, double du, const PosedScene& posed,
                    const Camera& camera, Size size, const ProbeRule& rule) {
  CurvePoint at{.point = owned.curve.at(u), .patch_a = owned.patch_a, .patch_b = owned.patch_b};
  at.image = *picture_of(camera, at.point);
  const ImagePoint before = *picture_of(camera, owned.curve.at(u - du)),
                   after = *picture_of(camera, owned.curve.at(u + du));
  const double length = std::max(distance(before, after), 1e-12);
  at.tangent = {(after.x - before.x) / length, (after.y - before.y) / length};
  const bool inside = at.image.x >= -0.5 && at.image.y >= -0.5 && at.image.x <= size.width - 0.5 &&
                      at.image.y <= size.height - 0.5;
  const Vec3d direction = normalized(owned.curve.at(u + du) - owned.curve.at(u - du));
  return {at.point, direction, at.image, inside ? probe_edge(posed, camera, at, rule) : EdgeSample{}};
}

bool same_edge(const EdgeSample& a, const EdgeSample& b) {
  return a.kind == b.kind && a.own == b.own && a.own_on_side == b.own_on_side;
}

/// A run of samples of one edge: first ... last, indices modulo the number of samples on a closed curve.
struct Run {
  int first = 0, last = 0;
};

/// Runs of equal samples; runs of the same edge are joined across a gap of at most `gap` samples.
std::vector<Run> runs_of(const std::vector<WalkedPoint>& points, bool closed, int gap) {
  std::vector<Run> runs;
  const int n = static_cast<int>(points.size());
  for (int i = 0; i < n; ++i) {
    const EdgeSample& sample = points[i].sample;
    if (sample.kind == EdgeKind::none) continue;
    const bool joins = !runs.empty() && i - runs.back().last <= gap + 1 &&
                       same_edge(points[runs.back().last].sample, sample);
    if (joins) {
      runs.back().last = i;
    } else {
      runs.push_back({i, i});
    }
  }
  const bool wraps = closed && runs.size() > 1 && runs.front().first + n - runs.back().last <= gap + 1 &&
                     same_edge(points[runs.front().first].sample, points[runs.back().last].sample);
  if (wraps) {
    runs.front().first = runs.back().first - n;
    runs.pop_back();
  }
  return runs;
}

/// Seen from the camera with x right and y down, normal x direction points to the right of the direction
/// where the normal points towards the camera.
Vec3d inward_direction(const OwnedCurve& owned, const WalkedPoint& p, int face) {
  const Vec3d normal = p.sample.own_normals[face];
  if (owned.silhouette) return -normal;
  const bool right = p.sample.first_face_right == (face == 0);
  const Vec3d across = normalized(cross(p.direction, normal));
  return right ? across : -across;
}

TrueEdge make_edge(const OwnedCurve& owned, const std::vector<WalkedPoint>& points, Run run) {
  const int n = static_cast<int>(points.size());
  TrueEdge edge{.object_id = owned.object_id};
  int reachable = 0, counted = 0;
  for (int i = run.first; i <= run.last; ++i) {
    const WalkedPoint& p = points[(i + n) % n];
    edge.line.push_back(p.image);
    if (p.sample.kind == EdgeKind::none) continue;
    ++counted;
    reachable += p.sample.reachable;
    edge.points.push_back(p.point);
    edge.inward[0].push_back(inward_direction(owned, p, 0));
    if (p.sample.own[1] != 0) edge.inward[1].push_back(inward_direction(owned, p, 1));
  }
  const EdgeSample& sample = points[(run.first + n) % n].sample;
  edge.kind = sample.kind;
  edge.faces = sample.own;
  edge.graspable = edge.kind != EdgeKind::concave && 2 * reachable >= counted;
  return edge;
}

double length_of(const ImagePath& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  return length;
}

std::vector<TrueEdge> walk_curve(const OwnedCurve& owned, const PosedScene& posed, const Camera& camera,
                                 Size size, const EdgeWalk& walk) {
  const double length = picture_length(owned.curve, camera);
  if (length < walk.shortest_px) return {};
  const int n = std::max(4, static_cast<int>(std::ceil(length / walk.step_px)));
  std::vector<WalkedPoint> points;
  for (int i = 0; i < n; ++i) {
    points.push_back(walk_to(owned, (i + 0.5) / n, 0.25 / n, posed, camera, size, walk.probe));
  }
  const int gap = static_cast<int>(walk.bridged_px / walk.step_px);
  std::vector<TrueEdge> edges;
  for (const Run& run : runs_of(points, owned.curve.closed(), gap)) {
    TrueEdge edge = make_edge(owned, points, run);
    // The ends of the curve itself lie half a step beyond the first and last sample.
    if (!owned.curve.closed() && run.first == 0) edge.line.front() = *picture_of(camera, owned.curve.at(0));
    if (!owned.curve.closed() && run.last == n - 1) edge.line.back() = *picture_of(camera, owned.curve.at(1));
    if (owned.curve.closed() && run.last - run.first == n - 1) edge.line.push_back(edge.line.front());
    edge.length_px = length_of(edge.line);
    if (edge.length_px >= walk.shortest_px) edges.push_back(std::move(edge));
  }
  return edges;
}

}  // namespace

std::vector<TrueEdge> true_edges(const Scene& scene, const RigidMotion& T_world_camera,
                                 const PosedScene& posed, const Camera& camera, Size size,
                                 const EdgeWalk& walk) {
  std::vector<TrueEdge> edges;
  for (const OwnedCurve& owned : curves_of(scene, T_world_camera.inverse())) {
    std::vector<TrueEdge> more = walk_curve(owned, posed, camera, size, walk);
    edges.insert(edges.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  return edges;
}

}  // namespace facet
