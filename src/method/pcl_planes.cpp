#include "method/pcl_planes.hpp"

#include <limits>
#include <opencv2/ximgproc.hpp>
#include <pcl/features/impl/organized_edge_detection.hpp>
#include <pcl/features/integral_image_normal.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include "method/plane_surfaces.hpp"
#include "method/wall_time.hpp"
#include "prediction/label_images.hpp"

namespace facet {
namespace {

using Points = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using Edges = pcl::OrganizedEdgeFromNormals<pcl::PointXYZ, pcl::Normal, pcl::Label>;

Points::Ptr points_of(const Frame& frame) {
  auto points = std::make_shared<Points>(frame.depth_m.width(), frame.depth_m.height());
  points->is_dense = false;
  constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
  for (int y = 0; y < frame.depth_m.height(); ++y)
    for (int x = 0; x < frame.depth_m.width(); ++x) {
      const float z = frame.depth_m(x, y);
      const Vec3 p = frame.camera.back_project(static_cast<float>(x), static_cast<float>(y), z);
      points->at(x, y) = z > 0 ? pcl::PointXYZ(p.x, p.y, p.z) : pcl::PointXYZ(unknown, unknown, unknown);
    }
  return points;
}

/// Whether the surface bends outwards at a crease: the normals on its two sides turn apart. Looked at along
/// the image axis over which they differ most.
bool is_convex(const Points& points, const Normals& normals, int x, int y) {
  constexpr int reach_px = 4;
  float strongest = 0, sign = 0;
  for (const auto& [dx, dy] : {std::pair{reach_px, 0}, std::pair{0, reach_px}}) {
    const int x0 = x - dx, x1 = x + dx, y0 = y - dy, y1 = y + dy;
    if (x0 < 0 || y0 < 0 || x1 >= static_cast<int>(points.width) || y1 >= static_cast<int>(points.height))
      continue;
    const Eigen::Vector3f turn =
        normals.at(x1, y1).getNormalVector3fMap() - normals.at(x0, y0).getNormalVector3fMap();
    const Eigen::Vector3f step = points.at(x1, y1).getVector3fMap() - points.at(x0, y0).getVector3fMap();
    if (!(turn.norm() > strongest) || !step.allFinite()) continue;
    strongest = turn.norm();
    sign = turn.dot(step);
  }
  return sign > 0;
}

class PclPlaneMethod final : public Method {
 public:
  PclPlaneMethod(const PclPlaneParams& params, const DepthNoise& noise) : params_(params), noise_(noise) {}

  void process(const Frame& frame, Prediction& prediction, StageTimes& times) override {
    times = {};
    prediction = {};
    times.total_ms = milliseconds_of([&] { find(frame, prediction); });
  }
  void reset_history() override {}

 private:
  void find(const Frame& frame, Prediction& prediction) const {
    const Points::Ptr points = points_of(frame);
    const Normals::Ptr normals = normals_of(points);
    prediction.labels.resize(frame.depth_m.size());
    prediction.edges.resize(frame.depth_m.size());
    find_edges(points, normals, prediction);
    describe_planes(frame, noise_, find_planes(points, normals, prediction), prediction);
    if (prediction.surfaces.empty()) prediction.note = "no plane was found";
  }

  Normals::Ptr normals_of(const Points::Ptr& points) const {
    pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setNormalEstimationMethod(decltype(estimation)::COVARIANCE_MATRIX);
    estimation.setMaxDepthChangeFactor(params_.max_depth_change);
    estimation.setNormalSmoothingSize(params_.smoothing_px);
    estimation.setInputCloud(points);
    auto normals = std::make_shared<Normals>();
    estimation.compute(*normals);
    return normals;
  }

  std::vector<Plane> find_planes(const Points::Ptr& points, const Normals::Ptr& normals,
                                 Prediction& prediction) const {
    pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label> segmentation;
    segmentation.setMinInliers(static_cast<unsigned>(params_.min_inliers));
    segmentation.setAngularThreshold(static_cast<double>(params_.angular_deg) * M_PI / 180);
    segmentation.setDistanceThreshold(static_cast<double>(params_.distance_mm) / 1000);
    segmentation.setInputNormals(normals);
    segmentation.setInputCloud(points);
    std::vector<pcl::ModelCoefficients> models;
    std::vector<pcl::PointIndices> inliers, label_pixels, borders;
    auto labels = std::make_shared<pcl::PointCloud<pcl::Label>>();
    std::vector<pcl::PlanarRegion<pcl::PointXYZ>, Eigen::aligned_allocator<pcl::PlanarRegion<pcl::PointXYZ>>>
        regions;
    if (params_.refine)
      segmentation.segmentAndRefine(regions, models, inliers, labels, label_pixels, borders);
    else
      segmentation.segment(models, inliers);
    std::vector<Plane> planes;
    const int width = static_cast<int>(points->width);
    for (std::size_t i = 0; i < models.size(); ++i) {
      const std::vector<float>& c = models[i].values;
      planes.push_back({{c[0], c[1], c[2]}, c[3]});
      for (const int index : inliers[i].indices)
        prediction.labels(index % width, index / width) = static_cast<std::uint16_t>(i + 1);
    }
    return planes;
  }

  void find_edges(const Points::Ptr& points, const Normals::Ptr& normals, Prediction& prediction) const {
    Edges detector;
    detector.setDepthDisconThreshold(params_.depth_jump);
    detector.setEdgeType(Edges::EDGELABEL_OCCLUDING | Edges::EDGELABEL_HIGH_CURVATURE);
    detector.setInputNormals(normals);
    detector.setInputCloud(points);
    pcl::PointCloud<pcl::Label> labels;
    std::vector<pcl::PointIndices> indices;
    detector.compute(labels, indices);
    Image<std::uint8_t>& codes = prediction.edges;
    Image<std::uint8_t> mask(codes.size(), 0);
    for (int y = 0; y < codes.height(); ++y)
      for (int x = 0; x < codes.width(); ++x) {
        const std::uint32_t flags = labels.at(x, y).label;
        const bool occluding = (flags & Edges::EDGELABEL_OCCLUDING) != 0;
        mask(x, y) = flags != 0 ? 255 : 0;
        const EdgeKind kind = occluding                            ? EdgeKind::depth
                              : flags == 0                         ? EdgeKind::none
                              : is_convex(*points, *normals, x, y) ? EdgeKind::convex
                                                                   : EdgeKind::concave;
        codes(x, y) = edge_code(kind, kind == EdgeKind::depth || kind == EdgeKind::convex);
      }
    cv::Mat thin;
    cv::ximgproc::thinning(as_mat(mask), thin, cv::ximgproc::THINNING_GUOHALL);
    for (int y = 0; y < codes.height(); ++y)
      for (int x = 0; x < codes.width(); ++x)
        if (thin.at<std::uint8_t>(y, x) == 0) codes(x, y) = 0;
  }

  PclPlaneParams params_;
  DepthNoise noise_;
};

}  // namespace

std::optional<PredictedParts> yields_pcl_planes(const MethodSpec&) {
  return PredictedParts{.edges = true, .poses = true};
}

std::string_view what_pcl_planes_lack() {
  return {};
}

std::unique_ptr<Method> make_pcl_planes(const MethodSpec& spec, const MethodContext& context) {
  return std::make_unique<PclPlaneMethod>(spec.pcl, noise_of(context.dataset_sensor));
}

}  // namespace facet
