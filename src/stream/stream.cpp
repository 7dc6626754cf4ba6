#include "stream/stream.hpp"

#include <algorithm>

#include "stream/frame_producer.hpp"
#include "stream/resident_memory.hpp"

namespace facet {
namespace {

double milliseconds(StreamClock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

/// Notes memory at most once a second: looking costs a system call.
class MemoryWatch {
 public:
  void look(MemoryUse& memory, StreamClock::time_point now) {
    if (now < next_) return;
    next_ = now + std::chrono::seconds(1);
    note(memory);
  }
  static void note(MemoryUse& memory) {
    memory.end_mb = resident_memory_mb();
    if (memory.after_warmup_mb == 0) memory.after_warmup_mb = memory.end_mb;
    memory.max_mb = std::max(memory.max_mb, memory.end_mb);
  }

 private:
  StreamClock::time_point next_{};
};

StreamSample sample_of(const Passage& passage, StreamClock::time_point start, StreamClock::time_point now) {
  return {passage.number,
          1e-3 * milliseconds(now - start),
          milliseconds(now - passage.due),
          milliseconds(now - passage.entered),
          static_cast<int>(passage.workspace->result.surfaces.size()),
          passage.filters,
          passage.workspace->result.times};
}

/// Takes the frames as they come out.
void drain(FilterChain& chain, StageFilters& filters, const FrameSink& sink, StreamClock::time_point start,
           StreamRecord& record) {
  const auto warmup = static_cast<std::size_t>(record.options.warmup);
  MemoryWatch watch;
  while (std::optional<Passage> passage = chain.take()) {
    const StreamClock::time_point now = StreamClock::now();
    record.samples.push_back(sample_of(*passage, start, now));
    if (passage->number >= warmup) watch.look(record.memory, now);
    sink(*passage);
    filters.give_back(*passage);
  }
  if (!record.samples.empty()) MemoryWatch::note(record.memory);
}

}  // namespace

StreamRecord run_stream(std::span<const FrameInput> frames, const FrameSchedule& schedule,
                        const StreamOptions& options, StageFilters& filters, const FrameSink& sink,
                        const std::atomic<int>& stop_signal) {
  StreamRecord record;
  record.options = options;
  record.frames_in_memory = frames.size();
  record.samples.reserve(schedule.frame_limit());
  FilterChain chain(filters.filters(), static_cast<std::size_t>(options.queue_frames));
  FrameProducer producer(frames, schedule, options, chain, stop_signal);
  const LoadMeter meter;
  const StreamClock::time_point start = StreamClock::now();
  {
    const std::jthread thread([&](const std::stop_token& stop) { producer.run(stop, start); });
    try {
      drain(chain, filters, sink, start, record);
    } catch (...) {
      chain.fail(std::current_exception());  // the producer may wait for room
      throw;
    }
  }
  record.offered = producer.offered();
  record.due = producer.due();
  record.late = producer.late();
  record.queues = chain.queue_statistics();
  record.load = meter.load();
  record.interrupted = stop_signal != 0;
  return record;
}

}  // namespace facet
