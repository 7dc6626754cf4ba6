#pragma once

#include <string>
#include <vector>

#include "pipeline/stage_id.hpp"

namespace facet {

/// When frames are offered.
enum class StreamPace {
  fixed,     ///< at `rate_hz`
  recorded,  ///< as their time stamps say
  fastest,   ///< as soon as there is room
};

/// What happens where a frame comes and the first queue is full.
enum class QueuePolicy {
  block,  ///< it waits: every frame is processed, late if need be
  drop,   ///< the frame that has waited longest is given up
};

/// Consecutive stages that are run together on a frame.
struct StreamFilter {
  std::string name;
  StageId until = StageId::objects;  ///< its last stage; the first one follows the filter before
  int threads = 1;                   ///< frames at a time
};

/// The section `stream` of an experiment.
struct StreamOptions {
  StreamPace pace = StreamPace::fixed;
  double rate_hz = 30;
  int frames = 0;      ///< offered; 0 = as many as `seconds` allow, or every frame once
  double seconds = 0;  ///< time of offering; 0 = no limit
  int warmup = 30;     ///< offered frames before those that count
  QueuePolicy policy = QueuePolicy::block;
  int queue_frames = 2;  ///< room of each queue
  /// The paper's nodes (sections 4.1.2 and 4.2): frame producer, surface segmentation, pose.
  std::vector<StreamFilter> filters{{"preprocessing", StageId::wiener, 1},
                                    {"segmentation", StageId::validation, 2},
                                    {"poses", StageId::objects, 1}};
};

/// Throws Error{config} where the filters are not all stages in order, two have one name, or the first, which
/// averages over past frames, would run several frames at a time.
void validate(const StreamOptions& options);

}  // namespace facet
