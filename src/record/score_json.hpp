#pragma once

#include <nlohmann/json.hpp>

#include "score/frame_score.hpp"

namespace facet {

/// The counts of a frame's scores, all of them, so that tables can be made again without images.
nlohmann::json score_to_json(const FrameScore& score);
/// Throws nlohmann::json::exception where something is absent or of another type.
FrameScore score_from_json(const nlohmann::json& json);

}  // namespace facet
