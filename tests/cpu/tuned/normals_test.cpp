#include "cpu/tuned/normals.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "stage/normals.hpp"
#include "support/every_executor.hpp"
#include "support/masks.hpp"
#include "support/normal_planes.hpp"

namespace facet {
namespace {

constexpr Camera camera{525, 520, 300.3f, 244.8f};

template <class Executor>
Image<Vec3> normals_of(Executor& executor, const Image<float>& depth, const Mask& distance, int radius_px) {
  Image<std::int32_t> q(depth.size());
  NormalPlanes normal{Image<Vec3>(depth.size(), Vec3{7, 7, 7})};
  inverse_depth(executor, depth.view(), q.view());
  fit_normals(executor, radius_px, camera, std::as_const(q).view(), distance.view(), normal.views());
  return normal.vectors();
}

/// Windows of every size that stay inside the image, in no order.
Mask random_distance(Size size, int cap) {
  return make_image<std::uint8_t>(size, [&](int x, int y) {
    const int room = std::min({x + 1, y + 1, size.width - x, size.height - y});
    return std::min(room, static_cast<int>(noise_at(9, x, y) * static_cast<float>(cap + 1)));
  });
}

TEST(TunedNormals, GiveWhatThePlainOperationGivesToTheBit) {
  for_each_awkward_depth([](const Image<float>& depth) {
    for (const int radius_px : {1, 4, 16}) {
      if (radius_px == 16 && depth.width() > 100) continue;  // 33x33 windows on the shuffled grid
      const Mask distance = random_distance(depth.size(), radius_px + 1);
      expect_same_on_every_executor(
          [&](auto& executor) { return normals_of(executor, depth, distance, radius_px); });
    }
  });
}

TEST(TunedNormals, GiveTheSameAtTheNearestDepth) {  // the largest sums
  const Image<float> depth(Size{83, 61}, 0.02f);
  const Mask distance = random_distance(depth.size(), 17);
  expect_same_on_every_executor([&](auto& executor) { return normals_of(executor, depth, distance, 16); });
}

}  // namespace
}  // namespace facet
