#include "overlay/palette.hpp"

#include <gtest/gtest.h>

namespace facet {
namespace {

/// Tiles of 6 x 6 px with labels 1 .. columns * rows.
Image<std::uint16_t> tiles(int columns, int rows, int gap_px) {
  const int pitch = 6 + gap_px;
  Image<std::uint16_t> labels(Size{columns * pitch, rows * pitch}, 0);
  for (int y = 0; y < labels.height(); ++y)
    for (int x = 0; x < labels.width(); ++x)
      if (x % pitch < 6 && y % pitch < 6)
        labels(x, y) = static_cast<std::uint16_t>(1 + x / pitch + columns * (y / pitch));
  return labels;
}

TEST(Palette, neighbours_differ_even_across_a_gap_of_three_pixels) {
  for (const int gap_px : {0, 3}) {
    const auto colors = surface_colors(tiles(9, 7, gap_px));
    ASSERT_EQ(colors.size(), 63u);
    for (int label = 1; label <= 63; ++label) {
      if (label % 9 != 0) {
        EXPECT_NE(colors.at(label), colors.at(label + 1)) << label;
      }
      if (label + 9 <= 63) {
        EXPECT_NE(colors.at(label), colors.at(label + 9)) << label;
      }
    }
  }
}

TEST(Palette, more_neighbours_than_colours_still_get_colours) {
  // Eight labels that all touch the ninth.
  Image<std::uint16_t> labels(Size{80, 2}, 9);
  for (int x = 0; x < 80; ++x) labels(x, 0) = static_cast<std::uint16_t>(1 + x / 10);
  const auto colors = surface_colors(labels);
  EXPECT_EQ(colors.size(), 9u);
  for (int label = 1; label <= 8; ++label) EXPECT_NE(colors.at(label), colors.at(9));
}

TEST(Palette, a_large_surface_keeps_its_colour_to_itself) {
  Image<std::uint16_t> labels(Size{100, 100}, 1);
  for (int i = 0; i < 8; ++i) labels(12 * i + 5, 50) = static_cast<std::uint16_t>(2 + i);
  labels(99, 0) = 0;
  const auto colors = surface_colors(labels);
  for (int label = 2; label <= 9; ++label) EXPECT_NE(colors.at(label), colors.at(1));
}

TEST(Palette, an_image_without_labels_has_no_colours) {
  EXPECT_TRUE(surface_colors(Image<std::uint16_t>(Size{5, 5}, 0)).empty());
  EXPECT_TRUE(surface_colors({}).empty());
}

}  // namespace
}  // namespace facet
