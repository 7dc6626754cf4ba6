// Times the scores of one frame of 640x480 pixels with about 40 surfaces and 120 edges on one core.
//
//   bench_score                                   everything
//   bench_score --benchmark_filter=frame_score    all scores of a prediction
//
// The prediction is the truth, shifted by 2 px and with every fifth surface joined to the next.
#include <benchmark/benchmark.h>

#include "score/frame_score.hpp"
#include "score/summary.hpp"
#include "score/truth_prediction.hpp"
#include "synth/families.hpp"
#include "synth_io/scene_annotation.hpp"

namespace facet {
namespace {

struct Scene {
  Truth truth;
  Image<std::uint16_t> masks;
  Image<float> depth_m;
  std::vector<TruePose> poses;
};

/// The view of the family `complex` that comes nearest to 40 surfaces out of ten.
Scene crowded_scene() {
  const Camera camera = kinect_v1_camera();
  Scene best;
  for (std::uint64_t i = 0; i < 10; ++i) {
    const View view = random_layout(scene_family("complex"), 1, i, camera, kinect_v1_size()).view;
    const PosedScene posed(view.scene, view.T_world_camera);
    const Rendering exact = render(posed, camera, kinect_v1_size());
    const SceneTruth scene = scene_truth(view, posed, exact, camera);
    const auto off = [](std::size_t n) { return n > 40 ? n - 40 : 40 - n; };
    if (!best.truth.surfaces.empty() && off(scene.faces.size()) >= off(best.truth.surfaces.size())) continue;
    best = {truth_of(scene, exact), exact.object_ids, exact.depth_m, true_poses(scene)};
  }
  return best;
}
const Scene& scene() {
  static const Scene crowded = crowded_scene();
  return crowded;
}

template <class T>
Image<T> shifted(const Image<T>& image) {
  constexpr int shift_px = 2;
  Image<T> out(image.size(), T{});
  for (int y = 0; y < image.height(); ++y)
    std::copy_n(image.row(y), image.width() - shift_px, out.row(y) + shift_px);
  return out;
}

Prediction flawed(const FrameTruth& frame) {
  Prediction prediction = truth_as_prediction(frame);
  prediction.labels = shifted(prediction.labels);
  prediction.edges = shifted(prediction.edges);
  for (int y = 0; y < frame.size.height; ++y)
    for (int x = 0; x < frame.size.width; ++x)
      if (prediction.labels(x, y) % 5 == 1) ++prediction.labels(x, y);
  return prediction;
}

FrameTruth make_truth() {
  return frame_truth(scene().truth, scene().masks, scene().depth_m, scene().poses);
}

void time_frame_truth(benchmark::State& state) {
  scene();
  for (auto _ : state) benchmark::DoNotOptimize(make_truth());
  state.counters["surfaces"] = static_cast<double>(scene().truth.surfaces.size());
  state.counters["edges"] = static_cast<double>(scene().truth.edges.size());
}

void time_frame_score(benchmark::State& state) {
  const FrameTruth frame = make_truth();
  const Prediction prediction = flawed(frame);
  for (auto _ : state) benchmark::DoNotOptimize(score_frame(frame, prediction));
}

/// A prediction of stripes: as many edge pixels and regions as a broken method may give.
void time_striped_prediction(benchmark::State& state) {
  const FrameTruth frame = make_truth();
  Prediction prediction = truth_as_prediction(frame);
  for (int y = 0; y < frame.size.height; ++y) {
    for (int x = 0; x < frame.size.width; ++x) {
      prediction.edges(x, y) = y % 2 == 0 ? edge_code(EdgeKind::depth, true) : 0;
      prediction.labels(x, y) = static_cast<std::uint16_t>(1 + y / 2 + 240 * (x / 64));
    }
  }
  for (auto _ : state) benchmark::DoNotOptimize(score_frame(frame, prediction));
}

void time_summary(benchmark::State& state) {
  const FrameTruth frame = make_truth();
  ScoreCollection collection;
  collection.frames.assign(static_cast<std::size_t>(state.range(0)), {score_frame(frame, flawed(frame)), ""});
  for (auto _ : state) benchmark::DoNotOptimize(summarise_scores(collection));
}

BENCHMARK(time_frame_truth)->Name("frame_truth")->Unit(benchmark::kMillisecond);
BENCHMARK(time_frame_score)->Name("frame_score")->Unit(benchmark::kMillisecond);
BENCHMARK(time_striped_prediction)->Name("striped_prediction")->Unit(benchmark::kMillisecond);
BENCHMARK(time_summary)
    ->Name("summary/frames")
    ->Arg(3)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

}  // namespace
}  // namespace facet

BENCHMARK_MAIN();
