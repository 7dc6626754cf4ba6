#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gpu_frames.hpp"
#include "pipeline/pipeline.hpp"

namespace facet {

/// Makes the pipeline that is measured.
using MakePipeline = std::function<std::unique_ptr<Pipeline>()>;

/// Times [ms], smallest first.
class Times {
 public:
  Times() = default;
  explicit Times(std::vector<double> ms);
  std::size_t count() const { return ms_.size(); }
  /// 0 without any.
  double median() const { return ranked(0.5); }
  /// The smallest time that no less than this share of all is at or below; nothing where there are too few to
  /// tell: 64 for a share up to 0.9, 130 up to 0.95, 662 beyond.
  std::optional<double> quantile(double share) const;

 private:
  double ranked(double share) const;

  std::vector<double> ms_;
};

/// One frame after the other of a running sequence.
struct Latency {
  double first_ms = 0;  ///< of the first frame, which allocates
  Times total = {};
  std::vector<Times> stages = {};  ///< by StageId
};
Latency measure_latency(Pipeline& pipeline, std::span<const RawFrame> frames, int warmup, int repeats);

/// As many frames at a time as there are pipelines, each on a thread of its own with frames decoded before.
struct Throughput {
  int in_flight = 1;
  int frames = 0;
  double seconds = 0;
  Times latency = {};

  double frames_per_s() const { return frames / seconds; }
};
Throughput measure_throughput(const MakePipeline& make, std::span<const RawFrame> frames, int in_flight,
                              int count);

/// Frames per second that one thread turns from raw units into metres.
double decode_rate(std::span<const RawFrame> frames);

/// Frames whose results differ in a bit of labels, edges, outlines, planes, poses or grasps; each is
/// processed by itself.
std::vector<std::string> differing_frames(Pipeline& a, Pipeline& b, std::span<const RawFrame> frames);

/// Different results that `runs` runs over the same frame have.
int distinct_results(Pipeline& pipeline, const RawFrame& frame, int runs);

}  // namespace facet
