#include "dataset/azure_mkv.hpp"

#include <array>
#include <cstdio>

#include "core/error.hpp"
#include "dataset/azure_calibration.hpp"
#include "dataset/frame_checks.hpp"
#include "dataset/frame_list.hpp"
#include "dataset/intrinsics.hpp"
#include "dataset/mkv_depth_track.hpp"
#include "dataset/numbered_frames.hpp"
#include "dataset/timed_list.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& rule) {
  throw Error(ErrorKind::data, printable(path) + ": " + rule);
}

/// How the images are seen: the camera, and for each of its pixels the recorded one; empty: the same.
struct View {
  Camera camera;
  Image<std::int32_t> source{};
  std::string lens;  ///< what was done about it, for the description
};

View view_of(const DatasetSpec& spec, const MkvDepthInfo& info) {
  if (const auto camera = intrinsics_option(spec.options, spec.root.parent_path()))
    return {*camera, {}, "lens ignored, intrinsics given"};
  const AzureDepthMode* mode = azure_mode_of_size(info.size);
  if (mode == nullptr)
    fail(spec.root, "images of " + std::to_string(info.size.width) + "x" + std::to_string(info.size.height) +
                        " are of no depth mode");
  if (!info.depth_mode.empty() && info.depth_mode != mode->name)
    fail(spec.root, "the depth mode " + info.depth_mode + " has images of another size");
  if (info.calibration_json.empty())
    fail(spec.root, "calibration.json is not attached; give the option intrinsics");
  const LensModel lens =
      azure_depth_lens(info.calibration_json, *mode, printable(spec.root) + ": calibration.json");
  check_camera(lens.camera, info.size, spec.root);
  const std::string name(mode->name);
  if (!flag_option(spec.options, "undistort").value_or(true))
    return {lens.camera, {}, name + ", lens ignored"};
  return {lens.camera, undistortion_map(lens, info.size), name + ", lens taken out"};
}

std::vector<std::string> ids_of(const MkvDepthInfo& info) {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < info.times_us.size(); ++i) {
    char id[32];
    std::snprintf(id, sizeof id, "%06zu", i);
    ids.emplace_back(id);
  }
  return ids;
}

std::vector<std::string> remarks_on(const MkvDepthInfo& info) {
  std::vector<std::string> remarks;
  const auto remark = [&](std::size_t count, const char* what) {
    if (count > 0) remarks.push_back(entries_text(count) + " of the depth track " + what);
  };
  remark(info.broken, "left out: cut off, or of another size");
  remark(info.duplicates, "left out: another one has the time");
  remark(info.out_of_order, "out of order, put in order");
  if (info.ends_early_s) {
    char text[96];
    std::snprintf(text, sizeof text, "the file is cut off: the last %.2f s that it announces are not there",
                  *info.ends_early_s);
    remarks.emplace_back(text);
  }
  std::vector<double> times_s;
  for (const std::int64_t time_us : info.times_us) times_s.push_back(static_cast<double>(time_us) * 1e-6);
  if (const std::size_t lost = frames_lost(times_s); lost > 0)
    remarks.push_back(entries_text(lost) + " absent, by the times of the others");
  return remarks;
}

class AzureMkvDataset : public ListedDataset {
 public:
  AzureMkvDataset(const DatasetSpec& spec, Sensor sensor, std::unique_ptr<MkvDepthTrack> track, View view)
      : ListedDataset(spec, sensor, select_frames(spec, ids_of(track->info()))),
        path_(spec.root),
        track_(std::move(track)),
        view_(std::move(view)) {}

  std::string description() const override {
    const auto& times = track_->info().times_us;
    char text[96];
    std::snprintf(text, sizeof text, ", %zu frames in %.2f s, in ", times.size(),
                  static_cast<double>(times.back() - times.front()) * 1e-6);
    return "Azure Kinect recording, " + view_.lens + text + printable(path_);
  }
  bool is_sequence() const override { return true; }
  std::filesystem::path folder() const override { return path_.parent_path(); }
  std::vector<std::string> absent() const override { return remarks_on(track_->info()); }

  Frame load(std::size_t index) const override {
    Frame frame;
    frame.id = frame_id(index);
    frame.camera = view_.camera;
    frame.files = {path_};
    const std::int64_t time_us = track_->info().times_us.at(std::stoul(frame.id));
    frame.timestamp_s = static_cast<double>(time_us) * 1e-6;
    frame.depth_m = Image<float>(track_->info().size);
    frame.counted = {Image<std::uint16_t>(track_->info().size), 0.001};
    const std::vector<std::uint8_t> bytes = track_->read(time_us);
    for (int y = 0; y < frame.depth_m.height(); ++y)
      for (int x = 0; x < frame.depth_m.width(); ++x) {
        const std::uint16_t depth_mm = seen_at(x, y, bytes);
        frame.counted.counts(x, y) = depth_mm;
        frame.depth_m(x, y) = metres_of(depth_mm, frame.counted.unit_m);
        frame.missing_px += depth_mm == 0;
      }
    check_camera(frame.camera, frame.depth_m.size(), path_);
    check_depth_unit(frame.depth_m, path_);
    return frame;
  }

 private:
  std::uint16_t seen_at(int x, int y, const std::vector<std::uint8_t>& bytes) const {
    const std::int32_t source = view_.source.empty() ? y * track_->info().size.width + x : view_.source(x, y);
    if (source < 0) return 0;
    const auto at = 2 * static_cast<std::size_t>(source);
    return static_cast<std::uint16_t>(bytes[at] << 8 | bytes[at + 1]);
  }

  std::filesystem::path path_;
  std::unique_ptr<MkvDepthTrack> track_;
  View view_;
};

}  // namespace

std::span<const OptionInfo> azure_mkv_options() {
  static constexpr std::array<OptionInfo, 3> options{{
      {"undistort", OptionType::flag, "take the calibrated lens out of the images; true without it"},
      {"intrinsics", OptionType::numbers,
       "[fx, fy, cx, cy] in px, in place of the recording's calibration; the images stay as they are"},
      {"intrinsics_file", OptionType::text, "the same as a file with the 3x3 matrix K, beside the recording"},
  }};
  return options;
}

bool is_mkv(const std::filesystem::path& path) {
  return path.extension() == ".mkv" && std::filesystem::is_regular_file(path);
}

std::unique_ptr<Dataset> open_azure_mkv(const DatasetSpec& spec) {
  auto track = open_mkv_depth_track(spec.root);
  if (track->info().times_us.empty()) fail(spec.root, "no whole depth frame is in it");
  View view = view_of(spec, track->info());
  const Sensor sensor = spec.sensor == Sensor::automatic ? Sensor::azure_kinect : spec.sensor;
  return std::make_unique<AzureMkvDataset>(spec, sensor, std::move(track), std::move(view));
}

}  // namespace facet
