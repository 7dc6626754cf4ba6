#include "stage/basins.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <set>

#include "stage/labelling.hpp"
#include "support/every_executor.hpp"
#include "support/masks.hpp"
#include "support/mat.hpp"

namespace facet {
namespace {

using Roots = Image<std::int32_t>;
constexpr int guard_px = 2;

template <class Executor>
Roots basins_of(Executor& executor, const Image<float>& strength, const Mask& distance, float floor = 0) {
  const CreaseHeight height{strength.view(), distance.view(), guard_px, floor};
  Mask off_floor(strength.size());
  Roots root(strength.size(), 77);
  mark_off_floor(executor, height, off_floor.view());
  label_components(executor, Image<float>(strength.size(), 1.0f).view(), off_floor.view(), root.view());
  crease_basins(executor, height, root.view());
  return root;
}
Roots basins_of(const Image<float>& strength, const Mask& distance, float floor = 0) {
  CpuExecutor executor;
  return basins_of(executor, strength, distance, floor);
}
template <class Executor>
Mask borders_of(Executor& executor, const Roots& region) {
  Mask border(region.size(), 9);
  region_borders(executor, region.view(), border.view());
  return border;
}

Image<float> rough_strength(Size size, std::uint64_t seed) {
  return make_image<float>(
      size, [&](int x, int y) { return 0.5f * (noise_at(seed, x / 3, y / 3) + noise_at(seed + 1, x, y)); });
}
/// Distances 0 (barrier) to 5.
Mask rough_distance(Size size) {
  return make_image<std::uint8_t>(size,
                                  [](int x, int y) { return std::min(5, std::abs(x - 20 - y / 4) / 2); });
}

/// Whether (x, y) is higher than its neighbour; of equal heights the later pixel is higher.
bool is_higher(const Image<float>& height, int x, int y, int nx, int ny) {
  const float h = height(x, y), hn = height(nx, ny);
  return h > hn || (h == hn && (y > ny || (y == ny && x > nx)));
}

TEST(Basins, EndInALocalMinimumEach) {
  const Image<float> strength = rough_strength({61, 43}, 4);
  const Roots root = basins_of(strength, Mask(Size{61, 43}, 5));
  std::set<std::int32_t> minima;
  for (int y = 0; y < 43; ++y)
    for (int x = 0; x < 61; ++x) {
      bool lowest = true;
      for (int i = 0; i < 8; i += 2) {
        const int nx = x + neighbour8(i).dx, ny = y + neighbour8(i).dy;
        if (strength.size().contains(nx, ny)) lowest &= !is_higher(strength, x, y, nx, ny);
      }
      EXPECT_EQ(root(x, y) == y * 61 + x, lowest) << "roots are the minima, and all of them";
      if (lowest) minima.insert(y * 61 + x);
    }
  for (int y = 0; y < 43; ++y)
    for (int x = 0; x < 61; ++x) EXPECT_EQ(minima.count(root(x, y)), 1u);
  EXPECT_GT(minima.size(), 20u);
}

TEST(Basins, AreWhereWaterRunsDownTheSteepestWay) {
  const Image<float> strength = rough_strength({61, 43}, 4);
  const Roots root = basins_of(strength, Mask(Size{61, 43}, 5));
  for (int y = 0; y < 43; ++y)
    for (int x = 0; x < 61; ++x) {
      int px = x, py = y;
      for (bool moved = true; moved;) {  // one step at a time to the lowest neighbour
        int bx = px, by = py;
        for (int i = 0; i < 8; i += 2) {
          const int nx = px + neighbour8(i).dx, ny = py + neighbour8(i).dy;
          if (strength.size().contains(nx, ny) && is_higher(strength, bx, by, nx, ny)) bx = nx, by = ny;
        }
        moved = bx != px || by != py;
        px = bx, py = by;
      }
      EXPECT_EQ(root(x, y), py * 61 + px);
    }
}

TEST(Basins, MeetOnTheRidgeBetweenTwoValleys) {
  const auto ridge = make_image<float>(
      {41, 9}, [](int x, int) { return 1.0f - 0.04f * static_cast<float>(std::abs(x - 20)); });
  const Roots root = basins_of(ridge, Mask(Size{41, 9}, 5));
  for (int y = 0; y < 9; ++y) {
    EXPECT_EQ(root(0, y), root(19, y));
    EXPECT_EQ(root(21, y), root(40, y));
    EXPECT_NE(root(19, y), root(21, y));
  }
}

TEST(Basins, HaveOneLevelGroundForEachConnectedPartOfTheFloor) {
  const Size size{61, 43};
  const Image<float> strength = rough_strength(size, 4);
  const Roots root = basins_of(strength, Mask(size, 5), 0.4f);
  Mask low = make_image<std::uint8_t>(size, [&](int x, int y) { return strength(x, y) <= 0.4f; });
  cv::Mat_<int> label;
  cv::connectedComponents(as_mat(low), label, 4, CV_32S);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const int rx = root(x, y) % size.width, ry = root(x, y) / size.width;
      EXPECT_EQ(root(rx, ry), root(x, y)) << "a basin is named by one of its own pixels";
      if (low(x, y)) {
        EXPECT_EQ(label(ry, rx), label(y, x)) << "water on the floor stays where it is";
      }
      if (x > 0 && low(x, y) && low(x - 1, y)) {
        EXPECT_EQ(root(x, y), root(x - 1, y));
      }
    }
}

TEST(Basins, LeaveOutBarriersAndDoNotCrossThem) {
  Mask distance(Size{41, 9}, 5);
  for (int y = 0; y < 9; ++y) distance(20, y) = 0;
  const Roots root = basins_of(Image<float>(Size{41, 9}), distance);
  for (int y = 0; y < 9; ++y) {
    EXPECT_EQ(root(20, y), -1);
    EXPECT_EQ(root(5, y), 0);
    EXPECT_EQ(root(35, y), 21);
  }
}

TEST(Basins, TakePixelsNearADepthEdgeFromTheInsideOut) {
  const Size size{41, 9};  // strength is unknown near the barrier in column 0: no minimum may lie there
  const auto distance = make_image<std::uint8_t>(size, [](int x, int) { return std::min(x, 5); });
  const auto strength =
      make_image<float>(size, [](int x, int) { return x <= guard_px ? 0.0 : 0.5 + 0.01 * x; });
  const Roots root = basins_of(strength, distance);
  for (int y = 0; y < 9; ++y)
    for (int x = 1; x < 41; ++x) EXPECT_EQ(root(x, y), guard_px + 1) << x << ", " << y;
}

TEST(KnownStrength, EndsAtTheGuardBesideDepthEdges) {
  const Size size{9, 3};
  const auto distance = make_image<std::uint8_t>(size, [](int x, int) { return x; });
  const Image<float> strength(size, 0.5f);
  expect_same_on_every_executor([&](auto& executor) {
    Image<float> known(size);
    known_strength(executor, CreaseHeight{strength.view(), distance.view(), guard_px, 0}, known.view());
    for (int x = 0; x < 9; ++x) EXPECT_EQ(known(x, 1), x <= guard_px ? unknown_strength : 0.5f);
    return known;
  });
}

TEST(RegionBorders, CloseEveryRegion) {
  CpuExecutor executor;
  const Size size{61, 43};
  const Roots root = basins_of(rough_strength(size, 9), rough_distance(size));
  const Mask border = borders_of(executor, root);
  Mask open =
      make_image<std::uint8_t>(size, [&](int x, int y) { return border(x, y) == 0 && root(x, y) >= 0; });
  cv::Mat_<int> label;
  const int count = cv::connectedComponents(as_mat(open), label, 4, CV_32S);
  std::vector<std::set<int>> regions(static_cast<std::size_t>(count));
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      if (open(x, y)) regions[static_cast<std::size_t>(label(y, x))].insert(root(x, y));
  for (int i = 1; i < count; ++i) EXPECT_EQ(regions[static_cast<std::size_t>(i)].size(), 1u);
  EXPECT_GT(count, 10);
}

TEST(RegionBorders, AreOnePixelWideAndNowhereElse) {
  CpuExecutor executor;
  const auto halves = make_image<std::int32_t>({41, 9}, [](int x, int) {
    return x < 20 ? 3 : x < 30 ? 7 : -1;
  });
  const auto expected = make_image<std::uint8_t>({41, 9}, [](int x, int) { return x == 19; });
  EXPECT_TRUE(same_image(borders_of(executor, halves), expected)) << "none towards a barrier";
}

TEST(Basins, AreTheSameOnEveryExecutor) {
  for (const Size size : awkward_sizes)
    for (const Image<float>& strength : {rough_strength(size, 5), Image<float>(size), random_depth(size, 3)})
      expect_same_on_every_executor([&](auto& executor) {
        std::tuple out{basins_of(executor, strength, rough_distance(size), 0.2f), Mask()};
        std::get<1>(out) = borders_of(executor, std::get<0>(out));
        return out;
      });
}

}  // namespace
}  // namespace facet
