#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/image_view.hpp"
#include "stage/fill_missing.hpp"

namespace facet {

/// What the sources around some pixels offer to them; by index in the padded image. Keeps its memory.
struct FillOffers {
  std::vector<float> mean_m, distance_m;
  std::vector<int> sources;  ///< listed last
  std::uint16_t pass = 0;
  std::vector<std::uint16_t> listed_in;  ///< pass in which a source was listed last
};

/// Working copy of a depth image for filling its holes: the sources that offer a value, and the pixels that
/// wait for one. Padded by two pixels of nothing, so that windows around sources at the image's edge need no
/// border test; pixels are named by their index in the padded image. In a pass each source's offer is
/// computed once, for all pixels around it. Keeps its memory between frames.
class FillGrid {
 public:
  void resize(Size size);  ///< no sources, nothing open
  ImageView<float> source() { return {source_.data() + index(0, 0), size_.width, size_.height, pitch_}; }
  ImageView<std::uint8_t> open() { return {open_.data() + index(0, 0), size_.width, size_.height, pitch_}; }
  int index(int x, int y) const { return (y + pad) * pitch_ + x + pad; }
  int x(int pixel) const { return pixel % pitch_ - pad; }
  int y(int pixel) const { return pixel / pitch_ - pad; }
  float source_at(int pixel) const { return source_[static_cast<std::size_t>(pixel)]; }

  /// The open pixels that have a source beside them, in raster order.
  void list_open_beside_sources(std::vector<int>& list);
  /// The best offer [m] of the sources around each of the pixels, one at least around each. Calls with other
  /// `offers` may run at the same time.
  void propose(FillOffers& offers, std::span<const int> pixels, float* means_m) const;
  /// Makes a pixel a source and closes it.
  void close(int pixel, float depth_m) {
    source_[static_cast<std::size_t>(pixel)] = depth_m;
    open_[static_cast<std::size_t>(pixel)] = 0;
  }
  /// The open neighbours of the pixels, each listed once.
  void list_open_beside(const std::vector<int>& pixels, std::vector<int>& list);

 private:
  static constexpr int pad = 2;
  void list_sources_beside(std::span<const int> pixels, FillOffers& offers) const;
  void take_offers(int first, int second, FillOffers& offers) const;
  void find_best_means(const FillOffers& offers, int first, int second, float& first_m,
                       float& second_m) const;

  Size size_;
  int pitch_ = 2 * pad;
  std::array<int, 8> offsets_{};
  std::vector<float> source_;
  std::vector<std::uint8_t> open_;    ///< 1 = open, 2 = open and listed
  std::vector<std::uint8_t> marked_;  ///< a row
};

}  // namespace facet
