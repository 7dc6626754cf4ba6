#include "surface/border_lots.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace facet {
namespace {

using Lots = std::vector<std::vector<int>>;

/// Chains of basins, one per length: as many borders one after the other.
std::vector<BasinBorder> chains(const std::vector<int>& lengths) {
  std::vector<BasinBorder> borders;
  int basin = 0;
  for (const int length : lengths) {
    for (int i = 0; i < length; ++i, ++basin) borders.push_back({basin, basin + 1, 1});
    ++basin;
  }
  return borders;
}

int lot_with(const Lots& lots, int border) {
  const auto has_it = [border](const std::vector<int>& lot) {
    return std::find(lot.begin(), lot.end(), border) != lot.end();
  };
  return static_cast<int>(std::find_if(lots.begin(), lots.end(), has_it) - lots.begin());
}

TEST(BorderLots, OneLotHasAllBordersInTheirOrder) {
  EXPECT_EQ(BorderLots().cast(chains({1, 3, 1}), 8, 1), Lots({{0, 1, 2, 3, 4}}));
}

TEST(BorderLots, AnIslandIsInOneLotAndEveryBorderInOne) {
  BorderLots casting;
  const Lots lots = casting.cast(chains({3, 4, 2}), 12, 3);
  EXPECT_EQ(lots, Lots({{3, 4, 5, 6}, {0, 1, 2}, {7, 8}}));
  EXPECT_EQ(casting.cast(chains({2}), 4, 2), Lots({{0, 1}, {}})) << "the second time";
}

TEST(BorderLots, ARegionThatMeetsManyIsOfTheirIsland) {
  const std::vector<BasinBorder> borders{{1, 4, 1}, {0, 2, 1}, {2, 3, 1}, {3, 4, 1}, {5, 6, 1}};
  const Lots lots = BorderLots().cast(borders, 8, 2);
  EXPECT_EQ(lots, Lots({{0, 1, 2, 3}, {4}}));
}

TEST(BorderLots, LotsAreAboutAsLongAsEachOtherWhereTheIslandsLetThemBe) {
  const Lots lots = BorderLots().cast(chains({5, 9, 4, 2}), 24, 2);
  EXPECT_EQ(lots[0].size(), 11u);
  EXPECT_EQ(lots[1].size(), 9u);
  EXPECT_EQ(lot_with(lots, 5), lot_with(lots, 18)) << "nine and two";
}

TEST(BorderLots, ThereMayBeNoBorders) {
  EXPECT_EQ(BorderLots().cast({}, 5, 2), Lots({{}, {}}));
  EXPECT_EQ(BorderLots().cast({}, 0, 1), Lots({{}}));
}

}  // namespace
}  // namespace facet
