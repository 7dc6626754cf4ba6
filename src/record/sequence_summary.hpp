#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "record/frame_row.hpp"

namespace facet {

/// Median and 95 % quantile of `n` values; nothing where there are none.
struct Spread {
  std::optional<double> p50{}, p95{};
  std::size_t n = 0;
};

/// What a method did on a sequence, beside the scores against truth.
struct SequenceSummary {
  std::string dataset, method;
  std::size_t frames = 0;                                    ///< processed
  std::size_t with_truth = 0, with_time = 0, with_pose = 0;  ///< of these
  std::optional<double> duration_s{}, period_s{};            ///< first to last; median distance of frames

  std::optional<double> window_frames{};  ///< mean number of frames that were averaged
  std::optional<double> mean_age_s{},
      most_age_s{};                             ///< of the averaged readings: what averaging adds to latency
  std::map<std::string, std::size_t> starts{};  ///< windows by the reason they began

  std::size_t compared = 0, in_world = 0;          ///< pairs of consecutive frames; with the camera's poses
  std::optional<double> region_iou{}, covering{};  ///< mean best overlap of regions; of their pixels
  std::size_t before = 0, kept = 0;                ///< regions, and those found again in the next frame
  std::optional<double> life_s{};                  ///< mean time until a region is lost
  Spread normal_jitter_deg{}, centre_jitter_mm{};  ///< of planes about their own mean
};

/// One for every method and sequence among the rows, in the order of the rows.
std::vector<SequenceSummary> summarize_sequences(const std::vector<FrameRow>& rows);

/// metrics/sequences.json.
std::string sequences_json(const std::vector<SequenceSummary>& summaries);

}  // namespace facet
