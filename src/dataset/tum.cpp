#include "dataset/tum.hpp"

#include <array>

#include "core/error.hpp"
#include "dataset/frame_loader.hpp"
#include "dataset/intrinsics.hpp"
#include "dataset/recorded_sequence.hpp"
#include "dataset/timed_list.hpp"
#include "dataset/trajectory.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

constexpr Camera assumed_camera{525.0f, 525.0f, 319.5f, 239.5f};
constexpr DepthFormat depth_format{.unit_m = 1.0 / 5000};
constexpr double default_tolerance_s = 0.02, largest_tolerance_s = 1;

double tolerance_of(const DatasetSpec& spec) {
  const double tolerance_s = number_option(spec.options, "tolerance_s").value_or(default_tolerance_s);
  if (tolerance_s < 0 || tolerance_s > largest_tolerance_s)
    throw Error(ErrorKind::config, "option tolerance_s: expected 0 to 1 s");
  return tolerance_s;
}

/// A file that need not be there.
std::vector<TextLine> lines_if_there(const std::filesystem::path& path) {
  return std::filesystem::exists(path) ? read_text_lines(path) : std::vector<TextLine>();
}

void append(std::vector<std::string>& texts, std::vector<std::string> more) {
  for (std::string& text : more) texts.push_back(std::move(text));
}

/// Colours of the depth images, and remarks on those that have none.
std::vector<std::optional<std::size_t>> colors_of(const TimedList& depth, const TimedList& color,
                                                  double tolerance_s, std::vector<std::string>& remarks) {
  auto partner = associate(depth.files, color.files, tolerance_s);
  std::size_t alone = 0;
  for (const auto& found : partner) alone += !found;
  const std::size_t unused = color.files.size() - (depth.files.size() - alone);
  const std::string reach = " within " + std::to_string(static_cast<int>(1000 * tolerance_s)) + " ms";
  if (alone > 0) remarks.push_back(entries_text(alone) + " of depth.txt without colour" + reach);
  if (unused > 0) remarks.push_back(entries_text(unused) + " of rgb.txt left out: no depth" + reach);
  return partner;
}

}  // namespace

std::span<const OptionInfo> tum_options() {
  static constexpr std::array<OptionInfo, 3> options{{
      {"intrinsics", OptionType::numbers, "[fx, fy, cx, cy] in px; without it 525, 525, 319.5, 239.5"},
      {"intrinsics_file", OptionType::text, "file with the 3x3 matrix K, relative to the root"},
      {"tolerance_s", OptionType::number,
       "most that colour and poses may be away from the depth image [s]; 0.02 without it"},
  }};
  return options;
}

bool is_tum(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "depth.txt");
}

std::unique_ptr<Dataset> open_tum(const DatasetSpec& spec) {
  require_folder(spec.root);
  const double tolerance_s = tolerance_of(spec);
  const Camera camera = intrinsics_option(spec.options, spec.root).value_or(assumed_camera);
  const TimedList depth = timed_list(read_text_lines(spec.root / "depth.txt"), spec.root);
  const TimedList color = timed_list(lines_if_there(spec.root / "rgb.txt"), spec.root);
  const Trajectory trajectory(lines_if_there(spec.root / "groundtruth.txt"));

  RecordedSequence recording{.kind = "TUM RGB-D", .camera = camera, .format = depth_format};
  append(recording.remarks, depth.remarks("depth.txt"));
  append(recording.remarks, color.remarks("rgb.txt"));
  if (trajectory.broken_lines() > 0)
    recording.remarks.push_back(entries_text(trajectory.broken_lines()) +
                                " of groundtruth.txt left out: no pose");
  const auto colors = colors_of(depth, color, tolerance_s, recording.remarks);
  for (std::size_t i = 0; i < depth.files.size(); ++i) {
    const TimedFile& file = depth.files[i];
    RecordedFrame frame{file.file.stem(), {file.file}, file.timestamp_s, {}};
    if (colors[i]) frame.files.color = color.files[*colors[i]].file;
    frame.T_world_camera = trajectory.at(file.timestamp_s, tolerance_s);
    recording.frames.push_back(std::move(frame));
  }
  return open_recorded(spec, Sensor::kinect_v1, std::move(recording));
}

}  // namespace facet
