#pragma once

#include <cstdint>
#include <vector>

#include "core/image_view.hpp"
#include "stage/fill_missing.hpp"

namespace facet {

/// Working copy of a depth image for filling its holes: the sources that offer a value, and the pixels that
/// wait for one. Padded by two pixels of nothing, so that windows around sources at the image's edge need no
/// border test; pixels are named by their index in the padded image. Offers are computed once per
/// pass and kept for the pixels that share them. Keeps its memory between frames.
class FillGrid {
 public:
  void resize(Size size);  ///< no sources, nothing open
  ImageView<float> source() { return {source_.data() + index(0, 0), size_.width, size_.height, pitch_}; }
  ImageView<std::uint8_t> open() { return {open_.data() + index(0, 0), size_.width, size_.height, pitch_}; }
  int index(int x, int y) const { return (y + pad) * pitch_ + x + pad; }
  int x(int pixel) const { return pixel % pitch_ - pad; }
  int y(int pixel) const { return pixel / pitch_ - pad; }
  float source_at(int pixel) const { return source_[static_cast<std::size_t>(pixel)]; }
  bool has_source_beside(int pixel) const;

  /// What the sources around a pixel offer, in the state at the start of the pass.
  void start_pass() { ++pass_; }
  float best_mean(int pixel);

  /// Makes a pixel a source and closes it.
  void close(int pixel, float depth_m) {
    source_[static_cast<std::size_t>(pixel)] = depth_m;
    open_[static_cast<std::size_t>(pixel)] = 0;
  }
  /// Appends the open neighbours of a pixel to a list, each once.
  void list_open_beside(int pixel, std::vector<int>& list);

 private:
  static constexpr int pad = 2;
  const FillOffer& offer(int pixel);

  Size size_;
  int pitch_ = 2 * pad;
  int offsets_[8] = {};
  int pass_ = 0;
  std::vector<float> source_;
  std::vector<FillOffer> offer_;
  std::vector<int> offer_pass_;     ///< pass in which an offer was computed last
  std::vector<std::uint8_t> open_;  ///< 1 = open, 2 = open and listed
};

}  // namespace facet
