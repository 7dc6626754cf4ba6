#include "dataset/seven_scenes.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "dataset/frame_list.hpp"
#include "dataset/intrinsics.hpp"
#include "dataset/numbered_frames.hpp"
#include "dataset/recorded_sequence.hpp"
#include "dataset/timed_list.hpp"
#include "dataset/trajectory.hpp"

namespace facet {
namespace {

constexpr Camera assumed_camera{585.0f, 585.0f, 320.0f, 240.0f};
constexpr double frames_per_second = 30;

FramePattern depth_pattern() {
  return FramePattern("frame-{id}.depth.png");
}

/// The pose in a file; nothing where it is lost, as the recordings mark frames that could not be tracked.
std::optional<RigidMotion> read_pose(const std::filesystem::path& path) {
  std::array<double, 16> rows{};
  std::size_t count = 0;
  for (const TextLine& line : read_text_lines(path))
    for (const std::string& word : line) {
      const auto number = finite_number(word);
      if (!number || count == rows.size()) return std::nullopt;
      rows[count++] = *number;
    }
  return count == rows.size() ? motion_from_matrix(rows) : std::nullopt;
}

/// Adds the poses to the frames, and what is to be said of them.
void add_poses(const std::filesystem::path& root, RecordedSequence& recording) {
  const FramePattern pattern("frame-{id}.pose.txt");
  std::size_t missing = 0, broken = 0;
  for (RecordedFrame& frame : recording.frames) {
    const std::filesystem::path path = pattern.path(root, frame.id);
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error) || std::filesystem::file_size(path, error) == 0) {
      ++missing;
      continue;
    }
    frame.T_world_camera = read_pose(path);
    broken += !frame.T_world_camera;
  }
  if (missing > 0) recording.remarks.push_back(entries_text(missing) + " without a file of the pose");
  if (broken > 0) recording.remarks.push_back(entries_text(broken) + " whose file of the pose holds none");
}

}  // namespace

std::span<const OptionInfo> seven_scenes_options() {
  static constexpr std::array<OptionInfo, 3> options{{
      {"intrinsics", OptionType::numbers, "[fx, fy, cx, cy] in px; without it 585, 585, 320, 240"},
      {"intrinsics_file", OptionType::text, "file with the 3x3 matrix K, relative to the root"},
      {"registered", OptionType::flag,
       "colour was mapped to the depth images, and is read; false without it"},
  }};
  return options;
}

bool is_seven_scenes(const std::filesystem::path& folder) {
  return std::filesystem::is_directory(folder) && !std::filesystem::exists(folder / "dataset.yaml") &&
         !depth_pattern().list(folder).empty();
}

std::unique_ptr<Dataset> open_seven_scenes(const DatasetSpec& spec) {
  require_folder(spec.root);
  const Camera camera = intrinsics_option(spec.options, spec.root).value_or(assumed_camera);
  const NumberedFrames numbered = number_frames(depth_pattern().list(spec.root), frames_per_second);
  const bool with_color = flag_option(spec.options, "registered").value_or(false);
  RecordedSequence recording;
  recording.kind = "7-Scenes";
  recording.camera = camera;
  recording.remarks = numbered.remarks;
  recording.format.missing_codes = {65535};
  const FramePattern color("frame-{id}.color.png");
  for (const NumberedFrame& numbered_frame : numbered.frames) {
    RecordedFrame frame{numbered_frame.id,
                        {depth_pattern().path(spec.root, numbered_frame.id)},
                        numbered_frame.timestamp_s,
                        {}};
    if (with_color) frame.files.color = color.path(spec.root, frame.id);
    recording.frames.push_back(std::move(frame));
  }
  add_poses(spec.root, recording);
  return open_recorded(spec, Sensor::kinect_v1, std::move(recording));
}

}  // namespace facet
