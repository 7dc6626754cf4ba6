#include "cpu/tuned/crease_by_normals.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <tuple>

#include "support/every_executor.hpp"
#include "support/masks.hpp"
#include "support/normal_planes.hpp"

namespace facet {
namespace {

constexpr Camera camera{525, 520, 300.3f, 244.8f};

/// Windows of every size that stay inside the image, in no order.
Mask random_distance(Size size, int cap) {
  return make_image<std::uint8_t>(size, [&](int x, int y) {
    const int room = std::min({x + 1, y + 1, size.width - x, size.height - y});
    return std::min(room, static_cast<int>(noise_at(9, x, y) * static_cast<float>(cap + 1)));
  });
}

void expect_same(const Image<float>& depth, int radius_px, int guard_px) {
  const Mask distance = random_distance(depth.size(), radius_px + 1);
  CreaseParams params;
  params.radius_px = radius_px;
  params.depth_guard_px = guard_px;
  expect_same_on_every_executor([&](auto& executor) {
    Image<std::int32_t> q(depth.size());
    inverse_depth(executor, depth.view(), q.view());
    NormalPlanes scratch{Image<Vec3>(depth.size(), Vec3{7, 7, 7})};
    Image<float> strength(depth.size(), 7.0f);
    Mask direction(depth.size(), 7);
    crease_by_normals(executor, params, camera, std::as_const(q).view(), distance.view(), scratch.views(),
                      strength.view(), direction.view());
    return std::make_tuple(std::move(strength), std::move(direction));
  });
}

TEST(TunedCreaseByNormals, GivesWhatThePlainStageGivesToTheBit) {
  for_each_awkward_depth([](const Image<float>& depth) {
    expect_same(depth, 1, 0);
    expect_same(depth, 3, 3);
    if (depth.width() > 100) return;  // the shuffled grid is slow
    expect_same(depth, 4, 2);
    expect_same(depth, 16, 1);
  });
}

TEST(TunedCreaseByNormals, GivesTheSameWhereWindowsReachIntoOtherPiecesAndBands) {
  for (const Size size : {Size{64, 40}, Size{97, 35}, Size{1301, 21}}) {
    const Image<float> depth = random_depth(size, 8);
    for (const int radius_px : {2, 5, 16}) expect_same(depth, radius_px, 1);
  }
}

TEST(TunedCreaseByNormals, GivesTheSameAtTheNearestDepth) {  // the largest sums
  const auto depth = make_image<float>({83, 61}, [](int x, int) { return x % 7 < 3 ? 0.02f : 0.021f; });
  for (const int radius_px : {3, 16}) expect_same(depth, radius_px, 0);
}

}  // namespace
}  // namespace facet
