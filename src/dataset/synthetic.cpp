#include "dataset/synthetic.hpp"

#include <array>

#include "dataset/frame_list.hpp"
#include "synth/scene_truth.hpp"
#include "synth/synthetic_frame.hpp"
#include "synth_io/scene_annotation.hpp"

namespace facet {
namespace {

cv::Mat to_bgr(const Image<Rgb>& colour) {
  cv::Mat bgr(colour.height(), colour.width(), CV_8UC3);
  for (int y = 0; y < colour.height(); ++y)
    for (int x = 0; x < colour.width(); ++x)
      bgr.at<cv::Vec3b>(y, x) = {colour(x, y).b, colour(x, y).g, colour(x, y).r};
  return bgr;
}

cv::Mat to_mat(const Image<std::uint16_t>& ids) {
  cv::Mat mat(ids.height(), ids.width(), CV_16U);
  for (int y = 0; y < ids.height(); ++y) std::copy_n(ids.row(y), ids.width(), mat.ptr<std::uint16_t>(y));
  return mat;
}

std::size_t count_missing(const Image<float>& depth_m) {
  std::size_t missing = 0;
  for (int y = 0; y < depth_m.height(); ++y)
    missing += static_cast<std::size_t>(std::count(depth_m.row(y), depth_m.row(y) + depth_m.width(), 0.0f));
  return missing;
}

class SyntheticDataset : public ListedDataset {
 public:
  SyntheticDataset(const DatasetSpec& spec, Sensor sensor, std::vector<std::string> ids,
                   const SyntheticSpec& scenes)
      : ListedDataset(spec, sensor, std::move(ids)), scenes_(scenes), all_ids_(frame_ids(scenes)) {}

  std::string description() const override {
    return "built-in scenes '" + scenes_.scenes + "', seed " + std::to_string(scenes_.seed) +
           (scenes_.noise_free ? ", exact depth" : ", Kinect v1 noise");
  }

  Frame load(std::size_t index) const override {
    SyntheticFrame made = make(index);
    Frame frame;
    frame.id = frame_id(index);
    frame.color = to_bgr(made.exact.colour);
    frame.camera = made.camera;
    frame.object_masks = to_mat(made.exact.object_ids);
    frame.missing_px = count_missing(made.depth_m);
    frame.depth_m = std::move(made.depth_m);
    return frame;
  }

  std::optional<FrameAnnotation> annotation(std::size_t index, const Frame& frame) const override {
    const SyntheticFrame made = make(index);
    const PosedScene posed(made.view.scene, made.view.T_world_camera);
    const SceneTruth truth = scene_truth(made.view, posed, made.exact, made.camera);
    return FrameAnnotation{truth_of(truth, made.exact), masks_of(frame), true_poses(truth),
                           "geometry of the built-in scenes"};
  }

 private:
  SyntheticFrame make(std::size_t index) const {
    const auto place = std::find(all_ids_.begin(), all_ids_.end(), frame_id(index)) - all_ids_.begin();
    return make_frame(scenes_, static_cast<std::size_t>(place));
  }

  SyntheticSpec scenes_;
  std::vector<std::string> all_ids_;
};

}  // namespace

std::span<const OptionInfo> synthetic_options() {
  static constexpr std::array<OptionInfo, 3> options{{
      {"scenes", OptionType::text, "which built-in scenes; quickstart without it"},
      {"seed", OptionType::number, "of the layout and of the sensor noise; 1 without it"},
      {"noise", OptionType::flag, "measured by a simulated Kinect v1, or exact depth; true without it"},
  }};
  return options;
}

std::unique_ptr<Dataset> open_synthetic(const DatasetSpec& spec) {
  SyntheticSpec scenes;
  scenes.scenes = text_option(spec.options, "scenes").value_or(scenes.scenes);
  scenes.seed = seed_option(spec.options).value_or(1);
  scenes.noise_free = !flag_option(spec.options, "noise").value_or(true);
  const Sensor sensor = spec.sensor == Sensor::automatic ? Sensor::kinect_v1 : spec.sensor;
  return std::make_unique<SyntheticDataset>(spec, sensor, select_frames(spec, frame_ids(scenes)), scenes);
}

}  // namespace facet
