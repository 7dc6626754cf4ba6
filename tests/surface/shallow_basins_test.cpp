#include "surface/shallow_basins.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <utility>

#include "support/same_image.hpp"
#include "support/shuffled_grid.hpp"

namespace facet {
namespace {

constexpr Size size{24, 5};
constexpr float floor_strength = 0.1f;

bool are_equal(const BasinContact& l, const BasinContact& r) {
  return l.a == r.a && l.b == r.b && l.place == r.place && l.strength == r.strength;
}

/// Three basins side by side, each 8 px wide, named by their first pixel; strength 0.2 inside, and a pass at
/// column 7 and at column 15.
struct Columns {
  Image<std::int32_t> basin{size}, inverse_depth{size, 1000};
  Image<float> strength{size, 0.2f};
  Columns(float first_pass, float second_pass) {
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) basin(x, y) = x / 8 * 8;
      strength(7, y) = first_pass, strength(15, y) = second_pass;
    }
  }
  Image<std::int32_t> joined(const ShallowLimits& limits, int expected_count,
                             HostThreads&& threads = HostThreads()) const {
    Image<std::int32_t> region;
    std::vector<BasinContact> contacts, expected;
    const BasinLandscape landscape{basin.view(),    inverse_depth.view(), 0.001,
                                   strength.view(), floor_strength,       Camera{100, 100, 0, 0}};
    EXPECT_EQ(ShallowBasins().join(threads, landscape, limits, region, contacts), expected_count);
    collect_contacts(landscape, std::as_const(region).view(), 0, size.height, expected);
    EXPECT_TRUE(std::equal(contacts.begin(), contacts.end(), expected.begin(), expected.end(), are_equal));
    return region;
  }
};

TEST(ShallowBasins, JoinAcrossAPassThatIsLowerThanNoise) {
  const Image<std::int32_t> region = Columns(0.25f, 0.6f).joined({40}, 2);
  EXPECT_EQ(region(0, 0), 0);
  EXPECT_EQ(region(15, 4), 0);
  EXPECT_EQ(region(16, 2), 1);
}

TEST(ShallowBasins, StayApartAcrossAStepThatIsMoreThanNoise) {
  Columns columns(0.25f, 0.25f);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < 8; ++x) columns.inverse_depth(x, y) = 1012;
  const Image<std::int32_t> region = columns.joined({40, 0, 0.005, 3}, 2);
  EXPECT_NE(region(0, 0), region(8, 0));
  EXPECT_EQ(region(8, 0), region(16, 0));
  columns.joined({40, 0, 0.02, 0}, 1);
  columns.joined({40, 0, 0.005, 7}, 1);  // deviations of 0.19 %
}

TEST(ShallowBasins, StayApartWhereBothAreLarge) {
  const Image<std::int32_t> region = Columns(0.25f, 0.25f).joined({39}, 3);
  EXPECT_EQ(region(0, 0), 0);
  EXPECT_EQ(region(8, 0), 1);
  EXPECT_EQ(region(23, 4), 2);
}

TEST(ShallowBasins, JoinTheNeighbourAcrossTheLowestPassAndAreAsDeepAsItThen) {
  Columns columns(0.26f, 0.22f);
  EXPECT_EQ(columns.joined({40}, 1)(23, 4), 0);
  columns.strength(0, 0) = columns.strength(16, 0) = 0.05f;  // their bottoms
  const Image<std::int32_t> region = columns.joined({40}, 2);
  EXPECT_EQ(region(8, 0), region(16, 0));
  EXPECT_NE(region(0, 0), region(8, 0)) << "the pass is 0.21 above both bottoms";
}

TEST(ShallowBasins, AreTheSameForAnyNumberOfThreads) {
  const Columns columns(0.26f, 0.22f);
  EXPECT_TRUE(same_image(columns.joined({40}, 1, ShuffledGridExecutor()), columns.joined({40}, 1)));
  EXPECT_TRUE(same_image(columns.joined({39}, 3, ShuffledGridExecutor()), columns.joined({39}, 3)));
}

TEST(ShallowBasins, HaveNoPassWhereTheStrengthIsNotKnown) {
  Columns columns(0.25f, 0.25f);
  for (int y = 0; y < size.height; ++y) columns.strength(7, y) = unknown_strength;
  const Image<std::int32_t> region = columns.joined({40}, 2);
  EXPECT_NE(region(0, 0), region(8, 0));
  EXPECT_EQ(region(8, 0), region(16, 0));
}

/// Columns near depth edges: no strength is known. A step of 1 % lies between the first two, of 0.1 % between
/// the last two.
struct BlindColumns : Columns {
  BlindColumns() : Columns(0.25f, 0.25f) {
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        strength(x, y) = unknown_strength;
        inverse_depth(x, y) = x < 8 ? 1011 : x < 16 ? 1001 : 1000;
      }
  }
};

TEST(ShallowBasins, ThoseThatSeeNoStrengthJoinWhileTheyAreSmallTogether) {
  BlindColumns().joined({1000, 79, 0.02}, 3);
  BlindColumns().joined({0, 120, 0.02}, 1);
}

TEST(ShallowBasins, ThoseThatSeeNoStrengthJoinAcrossTheLeastStepFirst) {
  const Image<std::int32_t> region = BlindColumns().joined({0, 80, 0.02}, 2);
  EXPECT_NE(region(0, 0), region(8, 0));
  EXPECT_EQ(region(8, 0), region(16, 0));
}

TEST(ShallowBasins, ThoseThatSeeNoStrengthStayApartAcrossALargerStep) {
  const Image<std::int32_t> region = BlindColumns().joined({0, 1000, 0.005}, 2);
  EXPECT_NE(region(0, 0), region(8, 0));
  EXPECT_EQ(region(8, 0), region(16, 0));
}

TEST(ShallowBasins, ABasinThatSeesNoStrengthJoinsNoneThatDoes) {
  BlindColumns columns;
  columns.strength(16, 0) = 0.2f;
  const Image<std::int32_t> region = columns.joined({0, 1000, 0.005}, 3);
  EXPECT_NE(region(8, 0), region(16, 0));
}

TEST(ShallowBasins, LeaveOutWhatIsInNoBasin) {
  Columns columns(0.25f, 0.25f);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < 8; ++x) columns.basin(x, y) = -1;
  const Image<std::int32_t> region = columns.joined({0}, 2);
  EXPECT_EQ(region(3, 3), -1);
  EXPECT_EQ(region(8, 0), 0);
  EXPECT_EQ(region(16, 0), 1);
}

}  // namespace
}  // namespace facet
