// Runs every stage of the pipeline in a function of its own, for tools that count instructions by function.
//
//   valgrind --tool=callgrind count_stages default 640 480 2
//
// takes two frames of a running sequence through each stage of one of the shipped modes; the functions are
// called counted_<number of the stage>, whose names are printed first.
#include <array>
#include <cstdlib>
#include <fmt/core.h>
#include <string_view>
#include <utility>

#include "bench_scene.hpp"
#include "core/error.hpp"
#include "cpu/cpu_pipeline.hpp"
#include "experiment/experiment_reader.hpp"

namespace facet {
namespace {

template <int stage>
[[gnu::noinline]] void counted(Pipeline& pipeline, const FrameInput& frame, FrameResult& result) {
  constexpr auto id = static_cast<StageId>(stage);
  pipeline.run({id, id}, frame, result);
  asm volatile("");  // a function of its own, and no tail call
}

void count(const PipelineParams& params, Size size, int frames) {
  const BenchScene& scene = bench_scene(size);
  const auto pipeline = make_cpu_pipeline(params, 1);
  const FrameInput frame{scene.depth_m.view(), scene.camera};
  FrameResult result;
  for (int i = 0; i < params.temporal.frames; ++i) pipeline->process(frame, result);
  for (int i = 0; i < frames; ++i) [&]<int... stage>(std::integer_sequence<int, stage...>) {
      (counted<stage>(*pipeline, frame, result), ...);
    }
  (std::make_integer_sequence<int, stage_count>());
}

}  // namespace
}  // namespace facet

int main(int argc, char** argv) {
  if (argc != 5) {
    fmt::print(stderr, "usage: count_stages MODE WIDTH HEIGHT FRAMES\n");
    return 2;
  }
  for (int i = 0; i < facet::stage_count; ++i)
    fmt::print("counted_{} {}\n", i, facet::stage_names[static_cast<std::size_t>(i)].key);
  for (const facet::MethodSpec& mode :
       facet::load_experiment(FACET_CONFIGS "/osd_methods.yaml").experiment.methods)
    if (mode.name == argv[1])
      facet::count(mode.params, {std::atoi(argv[2]), std::atoi(argv[3])}, std::atoi(argv[4]));
}
