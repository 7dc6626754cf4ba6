#include "dataset/recorded_sequence.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

#include "core/error.hpp"
#include "dataset/frame_list.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

std::vector<std::string> ids_of(const RecordedSequence& recording) {
  std::vector<std::string> ids;
  for (const RecordedFrame& frame : recording.frames) ids.push_back(frame.id);
  return ids;
}

std::string duration_text(const std::vector<RecordedFrame>& frames) {
  if (frames.empty() || !frames.front().timestamp_s || !frames.back().timestamp_s) return {};
  char text[64];
  std::snprintf(text, sizeof text, " in %.2f s", *frames.back().timestamp_s - *frames.front().timestamp_s);
  return text;
}

class RecordedDataset : public ListedDataset {
 public:
  RecordedDataset(const DatasetSpec& spec, Sensor sensor, RecordedSequence recording)
      : ListedDataset(spec, sensor, select_frames(spec, ids_of(recording))),
        root_(spec.root),
        recording_(std::move(recording)) {
    for (const RecordedFrame& frame : recording_.frames) frame_called_[frame.id] = &frame;
  }

  std::string description() const override {
    const auto count = [&](auto&& has) {
      return std::to_string(std::count_if(recording_.frames.begin(), recording_.frames.end(), has));
    };
    return recording_.kind + " sequence, " + std::to_string(recording_.frames.size()) + " frames" +
           duration_text(recording_.frames) + ", " +
           count([](const RecordedFrame& frame) { return frame.files.color.has_value(); }) +
           " with colour, " +
           count([](const RecordedFrame& frame) { return frame.T_world_camera.has_value(); }) +
           " with a pose of the camera, in " + printable(root_);
  }
  bool is_sequence() const override { return true; }
  std::vector<std::string> absent() const override { return recording_.remarks; }

  Frame load(std::size_t index) const override {
    const RecordedFrame& recorded = *frame_called_.at(frame_id(index));
    Frame frame = load_frame(recorded.id, recorded.files, recording_.format, recording_.camera);
    frame.timestamp_s = recorded.timestamp_s;
    frame.T_world_camera = recorded.T_world_camera;
    return frame;
  }

 private:
  std::filesystem::path root_;
  RecordedSequence recording_;
  std::map<std::string, const RecordedFrame*> frame_called_;
};

}  // namespace

void require_folder(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder))
    throw Error(ErrorKind::data, printable(folder) + ": folder is missing");
}

std::unique_ptr<Dataset> open_recorded(const DatasetSpec& spec, Sensor sensor, RecordedSequence recording) {
  return std::make_unique<RecordedDataset>(spec, spec.sensor == Sensor::automatic ? sensor : spec.sensor,
                                           std::move(recording));
}

}  // namespace facet
