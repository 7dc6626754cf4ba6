#include "stream/stream_summary.hpp"

#include <span>

namespace facet {
namespace {

using Samples = std::span<const StreamSample>;

template <class Quantity>
TimeStatistics statistics_of(Samples samples, const Quantity& quantity) {
  std::vector<double> values;
  for (const StreamSample& sample : samples) values.push_back(quantity(sample));
  return summarize_times(values);
}

StreamTimes filter_times(Samples samples, const StreamFilter& filter, std::size_t index) {
  StreamTimes times{filter.name, filter.threads, {}, {}};
  times.wall = statistics_of(samples, [&](const StreamSample& s) { return s.filters[index].work_ms; });
  if (times.wall.n > 0)
    times.cpu_mean_ms =
        statistics_of(samples, [&](const StreamSample& s) { return s.filters[index].cpu_ms; }).mean_ms;
  return times;
}

void add_bound(const StreamRecord& record, StreamSummary& summary) {
  double sum_ms = 0;
  for (const StreamTimes& filter : summary.filters) {
    if (!filter.cpu_mean_ms) return;
    sum_ms += *filter.cpu_mean_ms;
  }
  summary.cpu_per_frame_ms = sum_ms;
  if (sum_ms > 0 && record.load.cores > 0) summary.most_hz = 1e3 * record.load.cores / sum_ms;
}

}  // namespace

StreamSummary summarize(const StreamRecord& record) {
  const Samples counted = Samples(record.samples).subspan(record.first_counted());
  StreamSummary summary;
  for (std::size_t i = 0; i < record.options.filters.size(); ++i)
    summary.filters.push_back(filter_times(counted, record.options.filters[i], i));
  // The clock of a thread does not see the threads that work for it inside a frame.
  if (record.threads_in_frame > 1)
    for (StreamTimes& filter : summary.filters) filter.cpu_mean_ms.reset();
  add_bound(record, summary);
  summary.pass.name = "pass";
  summary.pass.wall = statistics_of(counted, [](const StreamSample& s) { return s.pass_ms; });
  summary.latency.name = "end to end";
  summary.latency.wall = statistics_of(counted, [](const StreamSample& s) { return s.latency_ms; });
  for (const StageName& stage : stage_names) {
    StreamTimes times{std::string(stage.key), 0, {}, {}};
    const auto index = static_cast<std::size_t>(index_of(stage.id));
    times.wall = statistics_of(counted, [&](const StreamSample& s) { return s.stages.stage_ms[index]; });
    summary.stages.push_back(std::move(times));
  }
  summary.throughput_hz = record.throughput_hz();
  if (record.options.pace != StreamPace::fastest)
    summary.is_sustained = record.dropped() == 0 && record.late == 0 && record.offered == record.due;
  return summary;
}

}  // namespace facet
