#include "method/opencv_rgbd.hpp"

#include <limits>
#include <opencv2/rgbd/depth.hpp>

#include "method/pipeline_method.hpp"
#include "method/plane_surfaces.hpp"
#include "method/wall_time.hpp"

namespace facet {
namespace {

constexpr int no_plane = 255;  // of RgbdPlane's mask

cv::Mat matrix_of(const Camera& camera) {
  return (cv::Mat_<float>(3, 3) << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
}

/// The module wants NaN where depth is missing.
cv::Mat depth_with_nan(const Image<float>& depth_m) {
  cv::Mat depth(depth_m.height(), depth_m.width(), CV_32F);
  for (int y = 0; y < depth.rows; ++y)
    for (int x = 0; x < depth.cols; ++x)
      depth.at<float>(y, x) = depth_m(x, y) > 0 ? depth_m(x, y) : std::numeric_limits<float>::quiet_NaN();
  return depth;
}

class RgbdPlaneMethod final : public Method {
 public:
  RgbdPlaneMethod(const RgbdPlaneParams& params, const DepthNoise& noise)
      : params_(params),
        noise_(noise),
        planes_(cv::rgbd::RgbdPlane::RGBD_PLANE_METHOD_DEFAULT, params.block_px, params.min_area_px,
                static_cast<double>(params.distance_mm) / 1000, static_cast<double>(params.error_per_m)) {}

  void process(const Frame& frame, Prediction& prediction, StageTimes& times) override {
    times = {};
    prediction = {};
    times.total_ms = milliseconds_of([&] { find(frame, prediction); });
  }
  void reset_history() override {}

 private:
  void find(const Frame& frame, Prediction& prediction) {
    const cv::Mat camera = matrix_of(frame.camera), depth = depth_with_nan(frame.depth_m);
    cv::Mat points, normals, mask, coefficients;
    cv::rgbd::depthTo3d(depth, camera, points);
    normals_of(camera, depth.size())(points, normals);
    planes_(points, normals, mask, coefficients);
    std::vector<Plane> found;
    for (int i = 0; i < coefficients.rows; ++i) {
      const auto c = coefficients.at<cv::Vec4f>(i);
      found.push_back({{c[0], c[1], c[2]}, c[3]});
    }
    prediction.labels.resize(frame.depth_m.size());
    for (int y = 0; y < mask.rows; ++y)
      for (int x = 0; x < mask.cols; ++x) {
        const int plane = mask.at<std::uint8_t>(y, x);
        prediction.labels(x, y) = static_cast<std::uint16_t>(plane == no_plane ? 0 : plane + 1);
      }
    describe_planes(frame, noise_, std::move(found), prediction);
    if (prediction.surfaces.empty()) prediction.note = "no plane was found";
  }

  /// Its tables depend on the camera, and are kept from frame to frame.
  cv::rgbd::RgbdNormals& normals_of(const cv::Mat& camera, cv::Size size) {
    const bool fits = normals_ && normals_->getCols() == size.width && normals_->getRows() == size.height &&
                      cv::countNonZero(camera != camera_) == 0;
    if (fits) return *normals_;
    camera_ = camera;
    normals_ = cv::rgbd::RgbdNormals::create(size.height, size.width, CV_32F, camera,
                                             params_.normal_window_px, method_code(params_.normals));
    normals_->initialize();
    return *normals_;
  }
  static int method_code(RgbdNormals method) {
    switch (method) {
      case RgbdNormals::linemod:
        return cv::rgbd::RgbdNormals::RGBD_NORMALS_METHOD_LINEMOD;
      case RgbdNormals::sri:
        return cv::rgbd::RgbdNormals::RGBD_NORMALS_METHOD_SRI;
      default:
        return cv::rgbd::RgbdNormals::RGBD_NORMALS_METHOD_FALS;
    }
  }

  RgbdPlaneParams params_;
  DepthNoise noise_;
  cv::rgbd::RgbdPlane planes_;
  cv::Ptr<cv::rgbd::RgbdNormals> normals_;
  cv::Mat camera_;
};

}  // namespace

std::optional<PredictedParts> yields_planes(const MethodSpec&) {
  return PredictedParts{.poses = true};
}

std::unique_ptr<Method> make_opencv_rgbd(const MethodSpec& spec, const MethodContext& context) {
  return std::make_unique<RgbdPlaneMethod>(spec.rgbd, noise_of(context.dataset_sensor));
}

}  // namespace facet
