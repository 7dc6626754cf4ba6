#include "cpu/tuned/fill_missing.hpp"

#include <gtest/gtest.h>
#include <tuple>

#include "support/every_executor.hpp"
#include "support/masks.hpp"

namespace facet {
namespace {

template <class Executor>
std::tuple<Image<float>, Mask> filled(Executor& executor, const FillParams& params,
                                      const Image<float>& depth) {
  std::tuple out{depth, Mask(depth.size(), 9)};
  Mask open(depth.size(), 9), rim(depth.size(), 9);
  Image<float> proposal(depth.size());
  fill_missing(executor, params, std::get<0>(out).view(), std::get<1>(out).view(),
               {open.view(), rim.view(), proposal.view()});
  return out;
}

FillParams params_of(FillPrefer prefer, int max_passes, int max_hole_px, int rim_search_px = 48) {
  return {true, prefer, max_passes, max_hole_px, 0.02f, rim_search_px};
}

TEST(TunedFillMissing, GivesWhatThePlainOperationGives) {
  for_each_awkward_depth([](const Image<float>& depth) {
    const int most_passes = depth.width() > 100 ? 3 : 512;
    for (const FillParams& params :
         {params_of(FillPrefer::far, most_passes, 40), params_of(FillPrefer::nearest, most_passes, 40)})
      expect_same_on_every_executor([&](auto& executor) { return filled(executor, params, depth); });
  });
}

TEST(TunedFillMissing, GivesTheSameAtTheLimitsOfItsParameters) {
  for (const Image<float>& depth :
       {random_depth({83, 61}, 5), table_scene({83, 61}), random_depth({31, 7}, 2)})
    for (const FillPrefer prefer : {FillPrefer::far, FillPrefer::nearest})
      for (const FillParams& params :
           {params_of(prefer, 0, 40), params_of(prefer, 1, 40), params_of(prefer, 512, 0),
            params_of(prefer, 512, 1), params_of(prefer, 512, 6, 1)})
        expect_same_on_every_executor([&](auto& executor) { return filled(executor, params, depth); });
}

TEST(TunedFillMissing, GivesTheSameForFrameAfterFrameFromOneExecutor) {
  CpuExecutor reused;
  for (const Size size : {Size{83, 61}, Size{31, 7}, Size{83, 61}, Size{0, 0}, Size{90, 60}}) {
    CpuExecutor fresh;
    const Image<float> depth = random_depth(size, static_cast<std::uint64_t>(size.width));
    EXPECT_TRUE(same_image(filled(reused, FillParams{}, depth), filled(fresh, FillParams{}, depth)));
  }
}

}  // namespace
}  // namespace facet
