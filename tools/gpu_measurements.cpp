#include "gpu_measurements.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <set>

namespace facet {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::vector<Image<float>> decoded(std::span<const RawFrame> frames) {
  std::vector<Image<float>> depths(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) decode(frames[i], depths[i]);
  return depths;
}

/// The bytes of values, one after the other.
class Bytes {
 public:
  template <class T>
  void add(const T& value) {
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void add(Vec3 v) { add(v.x), add(v.y), add(v.z); }
  template <class T>
  void add(const Image<T>& image) {
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) add(image(x, y));
  }
  void add(const Polyline& line) {
    for (const ContourPoint& point : line) add(point.x), add(point.y);
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

void add_surface(Bytes& bytes, const Surface& surface) {
  bytes.add(surface.id), bytes.add(surface.area_px), bytes.add(surface.object);
  bytes.add(surface.contour.outer);
  for (const Polyline& hole : surface.contour.holes) bytes.add(hole);
  if (surface.plane) bytes.add(surface.plane->normal), bytes.add(surface.plane->d_m);
  if (surface.pose) bytes.add(surface.pose->centre_m), bytes.add(surface.pose->quaternion_wxyz);
  for (const Grasp& grasp : surface.grasps)
    bytes.add(grasp.contacts_m[0]), bytes.add(grasp.contacts_m[1]), bytes.add(grasp.score);
}

/// What a pipeline makes of one frame by itself, as bytes.
std::string result_of(Pipeline& pipeline, const RawFrame& frame) {
  Image<float> depth_m;
  decode(frame, depth_m);
  FrameResult result;
  pipeline.reset_history();
  pipeline.process(input_of(frame, depth_m), result);
  Bytes bytes;
  bytes.add(result.labels), bytes.add(result.edges);
  for (const Surface& surface : result.surfaces) add_surface(bytes, surface);
  for (const RejectedRegion& region : result.rejected) bytes.add(region.seed.x), bytes.add(region.area_px);
  return bytes.take();
}

}  // namespace

Times::Times(std::vector<double> ms) : ms_(std::move(ms)) {
  std::sort(ms_.begin(), ms_.end());
}

std::optional<double> Times::quantile(double share) const {
  const std::size_t least = share > 0.95 ? 662 : share > 0.9 ? 130 : 64;
  if (ms_.size() < least) return std::nullopt;
  return ranked(share);
}

double Times::ranked(double share) const {
  if (ms_.empty()) return 0;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(ms_.size())));
  return ms_[std::max<std::size_t>(rank, 1) - 1];
}

Latency measure_latency(Pipeline& pipeline, std::span<const RawFrame> frames, int warmup, int repeats) {
  const std::vector<Image<float>> depths = decoded(frames);
  std::vector<double> totals;
  std::vector<std::vector<double>> stages(stage_count);
  double first_ms = 0;
  FrameResult result;
  for (int run = 0; run < warmup + repeats; ++run) {
    const std::size_t i = static_cast<std::size_t>(run) % frames.size();
    pipeline.process(input_of(frames[i], depths[i]), result);
    if (run == 0) first_ms = result.times.total_ms;
    if (run < warmup) continue;
    totals.push_back(result.times.total_ms);
    for (std::size_t s = 0; s < stages.size(); ++s) stages[s].push_back(result.times.stage_ms[s]);
  }
  Latency latency{first_ms, Times(std::move(totals)), {}};
  for (std::vector<double>& stage : stages) latency.stages.emplace_back(std::move(stage));
  return latency;
}

Throughput measure_throughput(const MakePipeline& make, std::span<const RawFrame> frames, int in_flight,
                              int count) {
  const std::vector<Image<float>> depths = decoded(frames);
  std::vector<std::unique_ptr<Pipeline>> pipelines;
  std::vector<FrameResult> results(static_cast<std::size_t>(in_flight));
  for (FrameResult& result : results) {
    pipelines.push_back(make());
    pipelines.back()->process(input_of(frames[0], depths[0]), result);  // allocates
  }
  std::atomic<int> next{0};
  std::vector<std::vector<double>> times(results.size());
  const auto start = Clock::now();
  std::vector<std::future<void>> threads;
  for (std::size_t t = 0; t < results.size(); ++t)
    threads.push_back(std::async(std::launch::async, [&, t] {
      for (int k = next++; k < count; k = next++) {
        const std::size_t i = static_cast<std::size_t>(k) % frames.size();
        const auto begun = Clock::now();
        pipelines[t]->process(input_of(frames[i], depths[i]), results[t]);
        times[t].push_back(ms_since(begun));
      }
    }));
  for (std::future<void>& thread : threads) thread.get();
  const double seconds = ms_since(start) / 1000;
  std::vector<double> all;
  for (const std::vector<double>& some : times) all.insert(all.end(), some.begin(), some.end());
  return {in_flight, count, seconds, Times(std::move(all))};
}

double decode_rate(std::span<const RawFrame> frames) {
  constexpr int rounds = 5;
  Image<float> depth_m;
  decode(frames[0], depth_m);
  const auto start = Clock::now();
  for (int round = 0; round < rounds; ++round)
    for (const RawFrame& frame : frames) decode(frame, depth_m);
  return rounds * static_cast<double>(frames.size()) / (ms_since(start) / 1000);
}

std::vector<std::string> differing_frames(Pipeline& a, Pipeline& b, std::span<const RawFrame> frames) {
  std::vector<std::string> names;
  for (const RawFrame& frame : frames)
    if (result_of(a, frame) != result_of(b, frame)) names.push_back(frame.name);
  return names;
}

int distinct_results(Pipeline& pipeline, const RawFrame& frame, int runs) {
  std::set<std::string> results;
  for (int i = 0; i < runs; ++i) results.insert(result_of(pipeline, frame));
  return static_cast<int>(results.size());
}

}  // namespace facet
