#include "surface/basin_contacts.hpp"

#include <gtest/gtest.h>

#include "core/image.hpp"

namespace facet {
namespace {

TEST(CollectContacts, NamesBothRegionsThePlaceAndTheStrongerStrength) {
  constexpr Size size{3, 2};
  Image<std::int32_t> region(size, 4), inverse_depth(size, 1000);
  region(0, 1) = 1, region(2, 1) = -1;  // 4 4 4
  Image<float> strength(size, 0.25f);   // 1 4 -
  strength(0, 0) = 0.75f;
  strength(1, 1) = unknown_strength;
  std::vector<BasinContact> contacts(1);
  collect_contacts({region.view(), inverse_depth.view(), 0.001, strength.view(), 0, Camera{100, 100, 0, 0}},
                   region.view(), 0, size.height, contacts);
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_EQ(contacts[0].a, 1);
  EXPECT_EQ(contacts[0].b, 4);
  EXPECT_EQ(contacts[0].place, 1);  // below pixel 0
  EXPECT_EQ(contacts[0].strength, 0.75f);
  EXPECT_EQ(contacts[1].place, 2 * 3);  // right of pixel 3
  EXPECT_EQ(contacts[1].strength, unknown_strength);
}

}  // namespace
}  // namespace facet
