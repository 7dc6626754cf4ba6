#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "record/sequence_row.hpp"
#include "score/frame_score.hpp"

namespace facet {

enum class FrameStatus {
  ok,
  data_error,    ///< the frame could not be read
  method_error,  ///< the method could not process it
};
std::string_view status_name(FrameStatus status);

/// What became of one frame under one method: a line of frames.jsonl. Holds no times, so that it is the same
/// from run to run. All text is valid UTF-8.
struct FrameRow {
  std::string dataset;
  std::string frame;
  std::string method;
  FrameStatus status = FrameStatus::ok;
  std::string kind;          ///< what its data set's description calls it; empty: nothing
  bool is_sequence = false;  ///< one of consecutive frames
  std::string axis;          ///< what its data set varies; empty: nothing
  double level = 0;          ///< the value of that in this frame
  std::string reason;        ///< why it failed, or why it has no surface
  std::string config_hash;   ///< of the resolved experiment
  std::string input_hash;    ///< SHA-256 over what was read
  std::string build;         ///< commit of the program, "-dirty" where it had changes
  int width_px = 0;
  int height_px = 0;
  std::int64_t missing_px = 0;   ///< without depth
  std::int64_t labelled_px = 0;  ///< in some surface
  std::int64_t depth_edge_px = 0;
  std::int64_t convex_edge_px = 0;
  std::int64_t concave_edge_px = 0;
  int surfaces = 0;
  int posed = 0;                        ///< surfaces with a pose
  int curved = 0;                       ///< surfaces that one plane does not explain
  std::map<std::string, int> rejected;  ///< dropped regions by reason
  std::vector<std::string> pictures;    ///< paths relative to the run directory
  std::string truth_source;             ///< where its truth is from; empty: it is not annotated
  std::optional<FrameScore> score;      ///< of annotated frames that could be read
  std::optional<SequenceRow> sequence;  ///< of the frames of a sequence that were processed
};

/// Order of the published rows: data set, frame, method.
bool row_before(const FrameRow& a, const FrameRow& b);

std::string to_json_line(const FrameRow& row);
/// Throws Error{data} where the line is no whole row, as after a kill in the middle of a write.
FrameRow frame_row_from_json(std::string_view line);

/// metrics/frames.csv.
std::string frames_csv(const std::vector<FrameRow>& rows);

}  // namespace facet
