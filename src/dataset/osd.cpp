#include "dataset/osd.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "dataset/frame_list.hpp"
#include "dataset/frame_loader.hpp"
#include "dataset/intrinsics.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

constexpr Camera assumed_camera{525.0f, 525.0f, 319.5f, 239.5f};

const FramePattern& depth_pattern() {
  static const FramePattern pattern("disparity/{id}.png");
  return pattern;
}
const FramePattern& color_pattern() {
  static const FramePattern pattern("image_color/{id}.png");
  return pattern;
}
const FramePattern& mask_pattern() {
  static const FramePattern pattern("annotation/{id}.png");
  return pattern;
}

class OsdDataset : public ListedDataset {
 public:
  OsdDataset(const DatasetSpec& spec, Sensor sensor, std::vector<std::string> ids, const Camera& camera)
      : ListedDataset(spec, sensor, std::move(ids)), root_(spec.root), camera_(camera) {}

  std::string description() const override {
    return "Object Segmentation Database 0.2 in " + printable(root_);
  }

  Frame load(std::size_t index) const override {
    const std::string id = frame_id(index);
    FrameFiles files{depth_pattern().path(root_, id), color_pattern().path(root_, id)};
    if (const auto masks = mask_pattern().path(root_, id); std::filesystem::exists(masks))
      files.object_masks = masks;
    return load_frame(id, files, DepthFormat{.unit_m = 0.001}, camera_);
  }

 private:
  std::filesystem::path root_;
  Camera camera_;
};

}  // namespace

std::span<const OptionInfo> osd_options() {
  static constexpr std::array<OptionInfo, 2> options{{
      {"intrinsics", OptionType::numbers, "[fx, fy, cx, cy] in px; without it 525, 525, 319.5, 239.5"},
      {"intrinsics_file", OptionType::text, "file with the 3x3 matrix K, relative to the root"},
  }};
  return options;
}

std::unique_ptr<Dataset> open_osd(const DatasetSpec& spec) {
  if (std::filesystem::is_directory(spec.root / "image_color") &&
      !std::filesystem::exists(spec.root / "disparity"))
    throw Error(ErrorKind::data,
                printable(spec.root / "disparity") +
                    ": folder is missing; OSD's depth is a download of its own (OSD-0.2-depth.zip)");
  // A frame is listed when its depth or its colour is there, so that a lost file is a failed frame, not a
  // smaller n.
  auto ids = depth_pattern().list(spec.root);
  const auto color_ids = color_pattern().list(spec.root);
  ids.insert(ids.end(), color_ids.begin(), color_ids.end());
  std::sort(ids.begin(), ids.end(), natural_less);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const Camera camera = intrinsics_option(spec.options, spec.root).value_or(assumed_camera);
  const Sensor sensor = spec.sensor == Sensor::automatic ? Sensor::kinect_v1 : spec.sensor;
  return std::make_unique<OsdDataset>(spec, sensor, select_frames(spec, ids), camera);
}

}  // namespace facet
