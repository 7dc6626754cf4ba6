#include "cpu/tuned/edge_kind.hpp"

#include <gtest/gtest.h>

#include "stage/gradient.hpp"
#include "support/awkward_frames.hpp"
#include "support/every_executor.hpp"
#include "support/masks.hpp"

namespace facet {
namespace {

TEST(TunedEdgeKind, GivesWhatThePlainOperationGives) {
  const Camera camera{525, 525, 60, 45};
  for (const Size size : awkward_sizes)
    for (const Convexity convexity : {Convexity::signed_test, Convexity::hessian}) {
      const Image<float> depth = random_depth(size, 3);
      const Mask depth_edge = random_mask(size, 1, 0.05f), edge = random_mask(size, 2, 0.2f);
      expect_same_on_every_executor([&](auto& executor) {
        Image<float> gx(size), gy(size);
        gradient(executor, {}, depth.view(), gx.view(), gy.view());
        Mask copy = edge, code(size, 9);
        edge_kind(executor, EdgeKindParams{convexity, 1}, camera, depth.view(), std::as_const(gx).view(),
                  std::as_const(gy).view(), depth_edge.view(), copy.view(), code.view());
        return code;
      });
    }
}

}  // namespace
}  // namespace facet
