// Times every stage of the pipeline, and the whole of it, in the three shipped modes at four image sizes on
// one core, and the whole of it on two.
//
//   bench_stages                                        everything
//   bench_stages --benchmark_filter=paper/wiener        one stage of one mode, at every size
//   bench_stages --benchmark_filter='/total/640x480'    the whole pipeline at one size, on one thread
//   bench_stages --benchmark_filter='/two_threads/'     on two threads
//   bench_stages --benchmark_filter=copy                what copying an image takes
//
// Names are mode/stage/size. A stage is timed where it stands in the pipeline, on the input that the stages
// before it leave; "Time" is the median of its wall times over the frames, beside it the least and the 90 %
// quantile [ms] ("CPU" means nothing here). Bytes are those of the images that it reads and writes, each
// counted once per pass over it. The calibration block beside them is the one that every run of `facet`
// times: compare machines by the ratio to it.
#include <algorithm>
#include <benchmark/benchmark.h>
#include <fmt/core.h>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "bench_scene.hpp"
#include "core/image.hpp"
#include "cpu/cpu_pipeline.hpp"
#include "experiment/calibration.hpp"
#include "experiment/environment.hpp"
#include "experiment/experiment_reader.hpp"
#include "score/intervals.hpp"
#include "stage_traffic.hpp"

namespace facet {
namespace {

constexpr Size sizes[]{{320, 240}, {640, 480}, {640, 576}, {1280, 720}};
constexpr int frames = 64;  ///< timed, after as many as the temporal average needs

/// The times of `frames` frames of a running sequence, taken once per mode, size and number of threads: its
/// stages add up to its total.
struct Recording {
  std::vector<StageTimes> times;
  std::size_t surfaces = 0;
};
const Recording& record(const MethodSpec& mode, Size size, int threads = 1) {
  static std::map<std::tuple<std::string, int, int, int>, Recording> recordings;
  const auto [place, is_new] = recordings.try_emplace({mode.name, size.width, size.height, threads});
  Recording& recording = place->second;
  if (!is_new) return recording;
  const BenchScene& scene = bench_scene(size);
  const auto pipeline = make_cpu_pipeline(mode.params, 1, threads);
  FrameResult result;
  for (int i = 0; i < mode.params.temporal.frames + frames; ++i) {
    pipeline->process({scene.depth_m.view(), scene.camera}, result);
    if (i >= mode.params.temporal.frames) recording.times.push_back(result.times);
  }
  recording.surfaces = result.surfaces.size();
  return recording;
}

/// One benchmark; `time_of` picks the milliseconds that count.
template <class TimeOf>
void add(const MethodSpec& mode, std::string_view stage, Size size, int bytes_per_px, const TimeOf& time_of,
         int threads = 1) {
  const auto run = [mode, size, bytes_per_px, time_of, threads](benchmark::State& state) {
    const Recording& recording = record(mode, size, threads);
    std::vector<double> times_ms;
    for (const StageTimes& times : recording.times) times_ms.push_back(time_of(times));
    std::sort(times_ms.begin(), times_ms.end());
    for (auto _ : state) state.SetIterationTime(sorted_quantile(times_ms, 0.5) / 1000);
    state.counters["min_ms"] = times_ms.front();
    state.counters["p90_ms"] = sorted_quantile(times_ms, 0.9);
    if (bytes_per_px > 0) state.SetBytesProcessed(state.iterations() * bytes_per_px * size.area());
    state.counters["surfaces"] = static_cast<double>(recording.surfaces);
  };
  const std::string name = fmt::format("{}/{}/{}x{}", mode.name, stage, size.width, size.height);
  benchmark::RegisterBenchmark(name.c_str(), run)
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

void add_mode(const MethodSpec& mode) {
  for (const Size size : sizes) {
    int total = 0;
    for (const StageTraffic& row : stage_traffic()) {
      const int bytes_per_px = row.bytes_per_px.at(mode.name);
      const auto stage = static_cast<std::size_t>(index_of(row.id));
      if (bytes_per_px == StageTraffic::idle) continue;
      total += bytes_per_px;
      add(mode, stage_names[stage].key, size, bytes_per_px,
          [stage](const StageTimes& t) { return t.stage_ms[stage]; });
    }
    const auto total_of = [](const StageTimes& t) { return t.total_ms; };
    add(mode, "total", size, total, total_of);
    add(mode, "two_threads", size, total, total_of, 2);
  }
}

/// What a stage that only moves its bytes would need: an image of depths is copied.
void time_copy(benchmark::State& state, Size size) {
  const Image<float> from(size, 1.0f);
  Image<float> to(size);
  for (auto _ : state) {
    to = from;
    benchmark::DoNotOptimize(to.row(0));
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * 2 * static_cast<int>(sizeof(float)) * size.area());
}

void time_calibration(benchmark::State& state) {
  for (auto _ : state) state.SetIterationTime(measure_calibration().median_ms / 1000);
}

}  // namespace
}  // namespace facet

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const auto environment = nlohmann::json::parse(facet::environment_json());
  benchmark::AddCustomContext("cpu", environment.at("cpu").at("model").get<std::string>());
  benchmark::RegisterBenchmark("calibration", facet::time_calibration)
      ->UseManualTime()
      ->Iterations(3)
      ->Unit(benchmark::kMillisecond);
  for (const facet::Size size : facet::sizes)
    benchmark::RegisterBenchmark(fmt::format("copy/{}x{}", size.width, size.height).c_str(), facet::time_copy,
                                 size);
  for (const facet::MethodSpec& mode :
       facet::load_experiment(FACET_CONFIGS "/osd_methods.yaml").experiment.methods)
    facet::add_mode(mode);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
