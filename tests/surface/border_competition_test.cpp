#include "surface/border_competition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "core/image.hpp"
#include "core/random.hpp"
#include "support/same_image.hpp"
#include "support/shuffled_grid.hpp"

namespace facet {
namespace {

constexpr Size size{60, 40};
constexpr double unit = 1.0 / 4194304;
const Camera camera{500, 500, 29.5f, 19.5f};

/// Two patches that meet in column 30; q falls by `slope` per pixel on both sides of it.
struct Ridge {
  Image<std::int32_t> basin{size}, inverse_depth{size};
  Image<float> strength{size};
  std::array<PatchFit, 2> patches;

  explicit Ridge(double slope, double noise = 0) {
    std::array<PatchMoments, 2> moments;
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const double exact = 1.2 - slope * std::abs(x - 29.5);
        moments[x < 30 ? 0 : 1].add_run(x - 29.5, y - 19.5, 1, [&](int) { return exact; });
        const auto place = static_cast<std::uint64_t>(y * size.width + x);
        const double jitter = noise * (2 * random_uniform(2, 1, place) - 1);
        inverse_depth(x, y) = static_cast<std::int32_t>((exact + jitter) / unit);
      }
    for (std::size_t i = 0; i < 2; ++i) patches[i] = moments[i].fit({1e-9, 10, 10});
  }
  /// Regions whose border lies in column `begin`, after the competition.
  Image<std::int32_t> regions(int begin, int passes, HostThreads&& threads = HostThreads()) const {
    Image<std::int32_t> region(size);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) region(x, y) = y == 7 ? -1 : x < begin ? 0 : 1;
    const BasinLandscape landscape{basin.view(), inverse_depth.view(), unit, strength.view(), 0, camera};
    BorderCompetition().run(threads, {landscape, patches, kinect_v1_noise(), 1}, passes, region.view());
    return region;
  }
};

/// Columns between the border and the crease, at most over the rows.
int farthest_from_crease(const Image<std::int32_t>& region) {
  int farthest = 0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      if (region(x, y) >= 0 && region(x, y) != (x < 30 ? 0 : 1))
        farthest = std::max(farthest, x < 30 ? 30 - x : x - 29);
  return farthest;
}

TEST(BorderCompetition, MovesABorderToWhereThePatchesMeet) {
  for (const int begin : {27, 33}) EXPECT_LE(farthest_from_crease(Ridge(0.004).regions(begin, 4)), 1);
  EXPECT_LE(farthest_from_crease(Ridge(0.004, 0.002).regions(33, 4)), 1);
}

TEST(BorderCompetition, MovesByThatManyPixelsAtMost) {
  EXPECT_EQ(farthest_from_crease(Ridge(0.004).regions(40, 0)), 10);
  EXPECT_EQ(farthest_from_crease(Ridge(0.004).regions(40, 4)), 6);
}

TEST(BorderCompetition, LeavesWhatIsNoGainBeyondNoise) {
  EXPECT_EQ(farthest_from_crease(Ridge(0.0, 0.002).regions(38, 16)), 8);
  EXPECT_EQ(farthest_from_crease(Ridge(1e-5).regions(33, 16)), 3);
}

TEST(BorderCompetition, IsTheSameForAnyNumberOfThreads) {
  const Ridge ridge(0.004, 0.002);
  EXPECT_TRUE(same_image(ridge.regions(33, 4, ShuffledGridExecutor()), ridge.regions(33, 4)));
}

TEST(BorderCompetition, PixelsOfNoRegionStaySo) {
  const Image<std::int32_t> region = Ridge(0.004).regions(33, 4);
  for (int x = 0; x < size.width; ++x) EXPECT_EQ(region(x, 7), -1);
}

}  // namespace
}  // namespace facet
