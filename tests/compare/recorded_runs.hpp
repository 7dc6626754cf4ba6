#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "pipeline/stage_id.hpp"

namespace facet {

// The timing rows in tests/compare/data: `recorded_runs` runs of the default method over the gate's frames,
// in turn with as many in which one stage was slowed. record_runs.cpp writes them, gate_replay_test.cpp reads
// them.

inline constexpr int recorded_runs = 10;
inline constexpr StageId slowed_stage = StageId::crease_canny;
inline constexpr double slowed_share = 0.2;
/// The slowed stage, one that was not, and the total, which every row has.
inline constexpr std::array recorded_stages{slowed_stage, StageId::wiener};

/// The data set that stands for a run in the files.
inline std::string recorded_name(bool slowed, int run) {
  return (slowed ? "slowed_" : "plain_") + std::to_string(run);
}

}  // namespace facet
