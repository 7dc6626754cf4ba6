#include "score/connected_parts.hpp"

#include <gtest/gtest.h>

#include "core/neighbours.hpp"
#include "support/masks.hpp"

namespace facet {
namespace {

/// The pixels of the part that holds the seed, by flooding.
std::vector<Offset> flooded(const Image<std::uint16_t>& labels, Offset seed, Mask& seen) {
  std::vector<Offset> pixels{seed};
  seen(seed.dx, seed.dy) = 1;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    for (const Offset step : {Offset{0, -1}, Offset{-1, 0}, Offset{1, 0}, Offset{0, 1}}) {
      const Offset p{pixels[i].dx + step.dx, pixels[i].dy + step.dy};
      if (!labels.size().contains(p.dx, p.dy) || seen(p.dx, p.dy)) continue;
      if (labels(p.dx, p.dy) != labels(seed.dx, seed.dy)) continue;
      seen(p.dx, p.dy) = 1;
      pixels.push_back(p);
    }
  }
  return pixels;
}

void expect_flooded_parts(const Image<std::uint16_t>& labels, int least_px) {
  const ConnectedParts found = connected_parts(labels, least_px);
  Mask seen(labels.size(), 0);
  std::size_t part = 0;
  for (int y = 0; y < labels.height(); ++y) {
    for (int x = 0; x < labels.width(); ++x) {
      if (labels(x, y) == 0) {
        ASSERT_EQ(found.map(x, y), 0);
      }
      if (labels(x, y) == 0 || seen(x, y)) continue;
      const std::vector<Offset> pixels = flooded(labels, {x, y}, seen);
      const bool counts = static_cast<int>(pixels.size()) >= least_px;
      for (const Offset p : pixels) ASSERT_EQ(found.map(p.dx, p.dy), counts ? static_cast<int>(part) + 1 : 0);
      if (!counts) continue;
      ASSERT_LT(part, found.parts.size());
      EXPECT_EQ(found.parts[part].label, labels(x, y));
      EXPECT_EQ(found.parts[part].area_px, static_cast<int>(pixels.size()));
      ++part;
    }
  }
  EXPECT_EQ(found.parts.size(), part);
}

TEST(ConnectedParts, AreThoseThatFloodingFindsInTheSameOrder) {
  for_each_awkward_mask([](const Mask& mask) {
    const auto labels = make_image<std::uint16_t>(
        mask.size(), [&](int x, int y) { return mask(x, y) ? 1 + (x / 11 + y / 7) % 3 : 0; });
    expect_flooded_parts(labels, 1);
    expect_flooded_parts(labels, 12);
  });
}

}  // namespace
}  // namespace facet
