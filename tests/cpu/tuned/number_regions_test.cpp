#include "cpu/tuned/number_regions.hpp"

#include <gtest/gtest.h>

#include "cpu/executor.hpp"
#include "support/masks.hpp"
#include "support/same_image.hpp"

namespace facet {
namespace {

struct Numbered {
  int count = 0;
  Image<std::uint16_t> labels, kept;
  std::vector<RejectedRegion> rejected;
};

/// By the generic function or by the tuned one.
Numbered numbered(bool tuned, int threads, const PipelineParams& params, const Image<float>& depth,
                  const Mask& edge) {
  const Camera camera{525, 525, 60, 45};
  CpuExecutor executor(threads);
  Buffers<CpuExecutor> b;
  b.resize(depth.size());
  b.depth = depth;
  b.edge = edge;
  b.filled = random_mask(depth.size(), 9, 0.3f);
  RegionNumbering numbering;
  Numbered out;
  out.kept.resize(depth.size());
  out.count =
      tuned ? number_regions(executor, b, params, camera, numbering, out.kept, out.rejected)
            : number_regions<CpuExecutor>(executor, b, params, camera, numbering, out.kept, out.rejected);
  out.labels = b.label;
  return out;
}

TEST(TunedNumberRegions, GivesWhatTheGenericFunctionGives) {
  PipelineParams params;
  params.contours.mode = ContourMode::edge_map;
  for (const Size size : awkward_sizes)
    for (const int threads : {1, 3}) {
      const Image<float> depth = random_depth(size, 4);
      const Mask edge = line_mask(size, 5);
      const Numbered expected = numbered(false, 1, params, depth, edge),
                     found = numbered(true, threads, params, depth, edge);
      EXPECT_EQ(found.count, expected.count);
      EXPECT_TRUE(same_image(found.labels, expected.labels));
      EXPECT_TRUE(same_image(found.kept, expected.kept));
      ASSERT_EQ(found.rejected.size(), expected.rejected.size());
      for (std::size_t i = 0; i < found.rejected.size(); ++i) {
        EXPECT_EQ(found.rejected[i].seed, expected.rejected[i].seed);
        EXPECT_EQ(found.rejected[i].area_px, expected.rejected[i].area_px);
        EXPECT_EQ(found.rejected[i].reason, expected.rejected[i].reason);
      }
    }
}

}  // namespace
}  // namespace facet
