#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "record/ablation_row.hpp"
#include "record/frame_row.hpp"
#include "record/gallery.hpp"
#include "record/manifest.hpp"
#include "record/metrics_summary.hpp"
#include "record/sweep_row.hpp"
#include "record/timing_row.hpp"

namespace facet {

/// Time of the fixed operations that every run measures beside its methods, so that times of different
/// machines can be set in relation.
struct Calibration {
  int repeats = 0;
  double median_ms = 0;
  double min_ms = 0;
};

/// Everything a report is made from.
struct RunRecord {
  Manifest manifest;
  std::vector<FrameRow> frames;
  std::vector<ScoreResult> scores;
  TimingTable timing;
  std::vector<IoTime> io_times;
  std::vector<GalleryEntry> gallery;
  std::vector<GalleryEntry> disputed;  ///< frames that the methods disagree on, of gallery/disputed.json
  std::optional<Calibration> calibration;
  std::vector<AblationRow> ablation;                             ///< scores, then costs
  std::vector<SweepRow> sweep;                                   ///< scores, then times
  std::vector<std::pair<std::string, std::string>> environment;  ///< of env.json, nested keys joined by dots
};

/// Reads the stored rows of a run directory. Throws Error{data} where the directory is none or a file is
/// damaged; a last line of frames.jsonl that was cut off is left out.
RunRecord read_run(const std::filesystem::path& directory);

/// Whole rows of a frames.jsonl text.
std::vector<FrameRow> frame_rows_from_jsonl(std::string_view text);

std::string to_json(const Calibration& calibration);

}  // namespace facet
