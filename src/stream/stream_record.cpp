#include "stream/stream_record.hpp"

#include <algorithm>

namespace facet {

std::size_t StreamRecord::first_counted() const {
  const auto warm = static_cast<std::size_t>(options.warmup);
  const auto first = std::partition_point(samples.begin(), samples.end(),
                                          [&](const StreamSample& sample) { return sample.number < warm; });
  return static_cast<std::size_t>(first - samples.begin());
}

double StreamRecord::throughput_hz() const {
  const std::size_t first = first_counted();
  if (samples.size() < first + 2) return 0;
  return static_cast<double>(samples.size() - first - 1) / (samples.back().done_s - samples[first].done_s);
}

}  // namespace facet
