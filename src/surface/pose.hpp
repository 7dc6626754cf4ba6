#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/camera.hpp"
#include "core/depth_noise.hpp"
#include "core/image_view.hpp"
#include "surface/surface.hpp"

namespace facet {

enum class PoseCentre {
  inliers,  ///< mean of the inliers, projected on the plane
  contour,  ///< the paper: mean of the contour's pixels, lifted by the depth found there
};

struct PoseParams {
  bool enabled = true;
  PoseCentre centre = PoseCentre::inliers;
  int iterations = 128;             ///< most RANSAC hypotheses, 1..10000
  int max_points = 1024;            ///< size of the consensus set, 16..100000
  float inlier_sigmas = 3.0f;       ///< inlier threshold in standard deviations of the sensor noise, 0..100
  float min_inlier_mm = 4.0f;       ///< and at least this [mm], 0..1000
  float curved_below_share = 0.8f;  ///< a surface with a smaller inlier share is flagged as curved, 0..1
};

/// Points of one surface in the camera frame [m], as separate coordinates for the inner loop, with the
/// largest number of them known beforehand.
struct PointSample {
  std::vector<float> x, y, z;

  std::size_t size() const { return x.size(); }
  void add(Vec3 p) { x.push_back(p.x), y.push_back(p.y), z.push_back(p.z); }
  void resize(std::size_t n) { x.resize(n), y.resize(n), z.resize(n); }
  void set(std::size_t i, Vec3 p) { x[i] = p.x, y[i] = p.y, z[i] = p.z; }
  Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// A fitted plane, or the reason why there is none.
struct PlaneFit {
  std::optional<Plane> plane;
  float inlier_share = 0;
  float rms_m = 0;
  Vec3 centroid_m;          ///< mean of the inliers, on the plane
  std::string_view reason;  ///< set where `plane` is empty
};

/// Whether more than half of the points lie on the side of the plane that its normal points to.
bool lies_in_front(const PointSample& points, const Plane& plane);

/// Plane through most of the points: RANSAC over triples, score = number of points within `threshold_m`, ties
/// to the earliest hypothesis; it stops once a better one is unlikely (p < 1 %), and is refined by least
/// squares on its inliers. Deterministic in (seed, stream). Paper section 4.2.4.
PlaneFit fit_plane(const PointSample& points, const PoseParams& params, float threshold_m, std::uint64_t seed,
                   std::uint64_t stream);

/// Distance from its plane [m] up to which a point of a surface is an inlier, by the noise at its depth.
float plane_threshold_m(const PointSample& points, const PoseParams& params, const DepthNoise& noise);

/// Rotation of a surface: z = normal, x = normalise(up x z), y = z x x with up = -Y of the camera, or its X
/// axis where the normal is within 18 degrees of up (|z . up| > 0.95). The angle in the plane is a
/// convention.
SurfacePose pose_on_plane(const Plane& plane, Vec3 centre_m);

/// Unit vector, in the plane, along the longer side of the contour's minimum-area rectangle.
Vec3 rectangle_axis(const Polyline& outer, const Plane& plane, const Camera& camera);

/// What the pose of a surface is computed from.
struct PoseInput {
  ImageView<const float> depth_m;  ///< filtered depth
  ImageView<const std::uint16_t> labels;
  Camera camera;
  DepthNoise noise;
  std::uint64_t seed = 0;
};

/// Fits plane and pose to `surface`, sampled at `points`; fills plane, inlier_share, rms_m, curved, pose or
/// no_pose_reason.
void estimate_pose(const PoseInput& input, const PoseParams& params, const PointSample& points,
                   Surface& surface);

}  // namespace facet
