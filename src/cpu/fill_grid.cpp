#include "cpu/fill_grid.hpp"

#include <algorithm>
#include <cstring>

namespace facet {
namespace {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = int __attribute__((vector_size(16)));

Float4 load(const float* at) {
  Float4 four;
  std::memcpy(&four, at, sizeof four);
  return four;
}

/// Four offers side by side, compared as FillOffer does.
struct FourOffers {
  Float4 mean_m{}, distance_m = Float4{} + FillOffer{}.distance_m;

  void take_better(const FourOffers& other) {
    const auto better =
        (other.distance_m < distance_m) | ((other.distance_m == distance_m) & (other.mean_m > mean_m));
    mean_m = better ? other.mean_m : mean_m;
    distance_m = better ? other.distance_m : distance_m;
  }
  FourOffers rotated(Int4 lanes) const {
    return {__builtin_shuffle(mean_m, lanes), __builtin_shuffle(distance_m, lanes)};
  }
};

}  // namespace

void FillGrid::resize(Size size) {
  const int pitch = size.width + 2 * pad;
  const auto count = static_cast<std::size_t>(pitch) * static_cast<std::size_t>(size.height + 2 * pad) + 4;
  if (size != size_) {
    size_ = size;
    pitch_ = pitch;
    for (int i = 0; i < 8; ++i) offsets_[i] = neighbour8(i).dy * pitch + neighbour8(i).dx;
    source_.assign(count, 0);
    offer_.resize(count);
    offer_pass_.assign(count, -1);
    pass_ = 0;
  }
  open_.assign(count, 0);
}

bool FillGrid::has_source_beside(int pixel) const {
  for (const int offset : offsets_)
    if (source_at(pixel + offset) > 0) return true;
  return false;
}

float FillGrid::best_mean(int pixel) {
  FillOffer best;
  for (const int offset : offsets_)
    if (source_at(pixel + offset) > 0) best.take_better(offer(pixel + offset));
  return best.mean_m;
}

void FillGrid::list_open_beside(int pixel, std::vector<int>& list) {
  for (const int offset : offsets_) {
    std::uint8_t& state = open_[static_cast<std::size_t>(pixel + offset)];
    if (state != 1) continue;
    state = 2;
    list.push_back(pixel + offset);
  }
}

/// The nine windows that contain the source, a row of three at a time: lane k of a row of windows is the one
/// around the pixel k - 1 to the right, lane 3 is not used. Columns are summed downwards, then across, as in
/// FillCandidate.
const FillOffer& FillGrid::offer(int pixel) {
  const auto at = static_cast<std::size_t>(pixel);
  if (offer_pass_[at] == pass_) return offer_[at];
  offer_pass_[at] = pass_;
  FourOffers best;
  for (int dy = -1; dy <= 1; ++dy) {
    const float* centre = source_.data() + pixel + dy * pitch_;
    Float4 sum{};
    Int4 count{};
    for (int dx = -2; dx <= 0; ++dx) {
      const Float4 above = load(centre + dx - pitch_), row = load(centre + dx),
                   below = load(centre + dx + pitch_);
      sum += above + row + below;
      count -= (above > 0) + (row > 0) + (below > 0);  // true is -1
    }
    const Float4 mean = sum / __builtin_convertvector(count, Float4);
    const Float4 step = mean - source_[at];
    best.take_better({mean, step < 0 ? -step : step});
  }
  best.take_better(best.rotated(Int4{1, 2, 0, 3}));
  best.take_better(best.rotated(Int4{2, 0, 1, 3}));
  return offer_[at] = {best.mean_m[0], best.distance_m[0]};
}

}  // namespace facet
