#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/rigid_motion.hpp"
#include "dataset/frame_loader.hpp"
#include "dataset/registry.hpp"

namespace facet {

/// One frame of a recording, as its lists tell.
struct RecordedFrame {
  std::string id;
  FrameFiles files;
  std::optional<double> timestamp_s{};
  std::optional<RigidMotion> T_world_camera{};
};

/// A recording of consecutive frames in image files.
struct RecordedSequence {
  std::string kind;  ///< opens the description
  Camera camera;
  DepthFormat format{};
  std::vector<RecordedFrame> frames{};  ///< in the order of time
  std::vector<std::string> remarks{};   ///< what was left out, is absent or was put in order
};

/// Throws Error{data} where there is no such folder.
void require_folder(const std::filesystem::path& folder);

/// The recording as a data set; `sensor` holds where the spec names none. Throws as select_frames() does.
std::unique_ptr<Dataset> open_recorded(const DatasetSpec& spec, Sensor sensor, RecordedSequence recording);

}  // namespace facet
