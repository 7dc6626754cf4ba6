#include "cuda/tuned/region_table.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "stage/labelling.hpp"
#include "support/masks.hpp"
#include "support/ridges.hpp"
#include "support/same_image.hpp"
#include "support/shuffled_grid.hpp"
#include "surface/regions.hpp"

namespace facet {
namespace {

constexpr Camera camera{40, 40, 20, 15};

struct Numbers {
  Image<std::uint16_t> labels;
  std::vector<RejectedRegion> rejected;
  int count = 0;
};

struct Components {
  Image<std::int32_t> root;
  Image<float> depth_m;
  Mask filled;

  explicit Components(const Mask& edge)
      : root(edge.size()), depth_m(random_depth(edge.size(), 3)), filled(random_mask(edge.size(), 5, 0.4f)) {
    ShuffledGridExecutor grid;
    label_components(grid, depth_m.view(), edge.view(), root.view());
  }
  Numbers on_host(const ValidationParams& validation) const {
    Numbers out{Image<std::uint16_t>(root.size()), {}};
    RegionNumbering numbering;
    out.count = numbering.number(root.view(), depth_m.view(), filled.view(), camera, validation,
                                 out.labels.view(), out.rejected);
    return out;
  }
  Numbers on_grid(RegionTable<Image>& table, const ValidationParams& validation) const {
    Numbers out{Image<std::uint16_t>(root.size(), 77), {}};
    ShuffledGridExecutor grid(2);
    RegionNumbering numbering;
    table.number(grid, root.view(), depth_m.view(), filled.view(), out.labels.view(), [&](auto components) {
      out.count = numbering.choose(components, root.width(), camera, validation, out.rejected);
      return numbering.labels();
    });
    return out;
  }
};

void expect_same(const Components& components, RegionTable<Image>& table) {
  for (const ValidationParams& validation : {ValidationParams{}, {true, 4, 100, 3, 0.4f}, {false}}) {
    const Numbers expected = components.on_host(validation), result = components.on_grid(table, validation);
    EXPECT_EQ(result.count, expected.count);
    EXPECT_TRUE(same_image(result.labels, expected.labels));
    ASSERT_EQ(result.rejected.size(), expected.rejected.size());
    for (std::size_t i = 0; i < expected.rejected.size(); ++i) {
      EXPECT_EQ(result.rejected[i].seed, expected.rejected[i].seed);
      EXPECT_EQ(result.rejected[i].area_px, expected.rejected[i].area_px);
      EXPECT_EQ(result.rejected[i].reason, expected.rejected[i].reason);
    }
  }
}

TEST(RegionTable, NumbersAsTheHostDoes) {
  RegionTable<Image> table;
  for_each_awkward_mask([&](const Mask& edge) { expect_same(Components(edge), table); });
}

TEST(RegionTable, NumbersMoreComponentsThanItHasPlacesFor) {
  RegionTable<Image> table;
  Mask checkers(Size{97, 61});
  for (int y = 0; y < 61; ++y)
    for (int x = 0; x < 97; ++x) checkers(x, y) = (x + y) % 2 == 0;
  const Mask open(Size{97, 61}, 0);
  for (const Mask& edge : {open, checkers, open, checkers}) expect_same(Components(edge), table);
}

}  // namespace
}  // namespace facet
