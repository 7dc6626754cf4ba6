#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "score/stability.hpp"

namespace facet {

/// What a row tells of a frame as one of a sequence.
struct SequenceRow {
  std::optional<double> timestamp_s{};
  bool camera_posed = false;  ///< the pose of the camera is known
  WindowUse window;           ///< frames that were averaged
  FrameStability stability;
};

nlohmann::ordered_json sequence_to_json(const SequenceRow& row);
/// Throws nlohmann::json::exception where something is absent or of another type.
SequenceRow sequence_from_json(const nlohmann::json& json);

}  // namespace facet
