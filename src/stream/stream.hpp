#pragma once

#include <atomic>
#include <functional>
#include <span>

#include "stream/frame_schedule.hpp"
#include "stream/stage_filters.hpp"
#include "stream/stream_record.hpp"

namespace facet {

/// Told of every finished frame, in the order in which they were offered, on the thread that called; may move
/// the result's content out.
using FrameSink = std::function<void(Passage&)>;

/// Streams frames through filters until the schedule, a time limit or a signal number in `stop_signal` ends
/// it; frames that were taken in by then are finished. Throws what a filter or the sink throws, once all
/// threads have ended.
StreamRecord run_stream(std::span<const FrameInput> frames, const FrameSchedule& schedule,
                        const StreamOptions& options, StageFilters& filters, const FrameSink& sink,
                        const std::atomic<int>& stop_signal);

}  // namespace facet
