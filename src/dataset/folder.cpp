#include "dataset/folder.hpp"

#include <array>

#include "dataset/folder_layout.hpp"
#include "dataset/frame_loader.hpp"
#include "dataset/numbered_frames.hpp"
#include "dataset/recorded_sequence.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

class FolderDataset : public ListedDataset {
 public:
  FolderDataset(const DatasetSpec& spec, Sensor sensor, std::vector<std::string> ids, FolderLayout layout)
      : ListedDataset(spec, sensor, std::move(ids)), root_(spec.root), layout_(std::move(layout)) {}

  std::string description() const override {
    return std::string(layout_.sequence ? "sequence" : "images") + " in " + printable(root_);
  }
  bool is_sequence() const override { return layout_.sequence; }

  Frame load(std::size_t index) const override {
    const std::string id = frame_id(index);
    FrameFiles files{layout_.depth.path(root_, id)};
    if (layout_.color && layout_.registered) files.color = layout_.color->path(root_, id);
    return load_frame(id, files, layout_.format, layout_.camera);
  }

 private:
  std::filesystem::path root_;
  FolderLayout layout_;
};

}  // namespace

std::span<const OptionInfo> folder_options() {
  static constexpr std::array<OptionInfo, 10> options{{
      {"depth", OptionType::text, "pattern of the depth images, for example {id}.depth.png; required"},
      {"color", OptionType::text, "pattern of the colour images; none without it"},
      {"depth_unit_m", OptionType::number, "metres per unit of the depth images, 0.001 for mm; required"},
      {"intrinsics", OptionType::numbers, "[fx, fy, cx, cy] in px; this or intrinsics_file is required"},
      {"intrinsics_file", OptionType::text, "file with the 3x3 matrix K, relative to the folder"},
      {"registered", OptionType::flag, "colour fits the depth images pixel by pixel; false without it"},
      {"missing_codes", OptionType::numbers,
       "raw values that mean missing depth, beside 0, NaN and infinities"},
      {"sequence", OptionType::flag, "frames are consecutive in time; false without it"},
      {"rate_hz", OptionType::number,
       "of a sequence: frames per second, counted by the last number of their names; times are unknown "
       "without it"},
      {"sensor", OptionType::text, "auto, kinect_v1, azure_kinect or stereo; auto without it"},
  }};
  return options;
}

namespace {

/// The folder as a recording whose frames tell their time by their number.
RecordedSequence numbered_recording(const std::filesystem::path& root, const FolderLayout& layout) {
  const NumberedFrames numbered = number_frames(layout.depth.list(root), *layout.rate_hz);
  RecordedSequence recording{
      .kind = "numbered", .camera = layout.camera, .format = layout.format, .remarks = numbered.remarks};
  for (const NumberedFrame& frame : numbered.frames) {
    FrameFiles files{layout.depth.path(root, frame.id)};
    if (layout.color && layout.registered) files.color = layout.color->path(root, frame.id);
    recording.frames.push_back({frame.id, std::move(files), frame.timestamp_s, {}});
  }
  return recording;
}

}  // namespace

std::unique_ptr<Dataset> open_folder(const DatasetSpec& spec) {
  require_folder(spec.root);
  ReaderOptions options = spec.options;
  options.merge(read_dataset_yaml(spec.root));  // keeps what the spec says
  FolderLayout layout = folder_layout(options, spec.root);
  if (layout.rate_hz) return open_recorded(spec, layout.sensor, numbered_recording(spec.root, layout));
  auto ids = select_frames(spec, layout.depth.list(spec.root));
  const Sensor sensor = spec.sensor == Sensor::automatic ? layout.sensor : spec.sensor;
  return std::make_unique<FolderDataset>(spec, sensor, std::move(ids), std::move(layout));
}

}  // namespace facet
