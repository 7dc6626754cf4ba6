#include <atomic>
#include <cstdlib>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <new>

#include "cpu/executor.hpp"
#include "cpu/tuned/crease_by_normals.hpp"
#include "cpu/tuned/fill_missing.hpp"
#include "cpu/tuned/hysteresis.hpp"
#include "cpu/tuned/labelling.hpp"
#include "cpu/tuned/pruning.hpp"
#include "cpu/tuned/thinning.hpp"
#include "pipeline/modes.hpp"
#include "pipeline/pipeline_body.hpp"
#include "pipeline/small_scene.hpp"

namespace {
std::atomic<long> allocation_count{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocation_count;
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (!memory) throw std::bad_alloc();
  return memory;
}
}  // namespace

// Every allocation of this program through new is counted. Where one of each pair is inlined, the compiler
// takes them for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
[[gnu::noinline]] void* operator new[](std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void* operator new[](std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete[](void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete[](void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace facet {
namespace {

constexpr Size size{320, 240};

/// CpuExecutor that counts the allocations of each timed piece of work instead of its milliseconds.
class CountingExecutor : public CpuExecutor {
 public:
  template <class Work>
  void timed(double& allocations, const Work& work) {
    const long before = allocation_count;
    work();
    allocations += static_cast<double>(allocation_count - before);
  }
};

/// Allocations per stage of the last of several equal frames.
StageTimes allocations_after_warm_up(const PipelineParams& params) {
  const Camera camera = scaled_camera(size);
  const Image<float> depth = small_measured_scene(4, size, camera, 1);
  CountingExecutor executor;
  PipelineBody<CountingExecutor> body(executor, params, 1);
  FrameResult result;
  for (int frame = 0; frame < params.temporal.frames + 2; ++frame)
    body.process({depth.view(), camera}, result);
  return result.times;
}

TEST(Allocation, TheCounterCounts) {
  const long before = allocation_count;
  ::operator delete(::operator new(sizeof(int)));  // unlike a new-expression, not left out by a compiler
  EXPECT_EQ(allocation_count - before, 1);
}

TEST(Allocation, ThePerPixelStagesAllocateNothingAfterWarmUp) {
  for (const Mode& mode : modes) {
    const StageTimes counts = allocations_after_warm_up(mode.params);
    for (const StageName& stage : stage_names) {
      const double count = counts.stage_ms[static_cast<std::size_t>(index_of(stage.id))];
      if (count > 0) fmt::print("{}: {:16} {:6.0f} allocations per frame\n", mode.name, stage.key, count);
      if (stage.id >= StageId::contours) break;
      EXPECT_EQ(count, 0) << mode.name << ", " << stage.key;
    }
  }
}

TEST(Allocation, TheHostStagesAllocateAFewTimesPerSurface) {
  const Camera camera = scaled_camera(size);
  const Image<float> depth = small_measured_scene(4, size, camera, 1);
  CountingExecutor executor;
  PipelineBody<CountingExecutor> body(executor, {}, 1);
  FrameResult result;
  for (int frame = 0; frame < 7; ++frame) body.process({depth.view(), camera}, result);
  ASSERT_FALSE(result.surfaces.empty());
  for (const StageId id :
       {StageId::contours, StageId::validation, StageId::pose, StageId::grasps, StageId::objects}) {
    const auto stage = static_cast<std::size_t>(index_of(id));
    const double each = result.times.stage_ms[stage] / static_cast<double>(result.surfaces.size());
    fmt::print("{:12} {:5.1f} allocations per surface\n", stage_names[stage].key, each);
    EXPECT_LT(each, 60) << stage_names[stage].key;
  }
}

}  // namespace
}  // namespace facet
