#include "cpu/fill_grid.hpp"

#include <algorithm>
#include <cstring>

#include "cpu/clones.hpp"
#include "cpu/sparse_row.hpp"

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
  /// The best of lanes 0 ... 2, in lane 0.
  FourOffers best_of_three() const {
    FourOffers best = *this;
    best.take_better(best.rotated(Int4{1, 2, 0, 3}));
    best.take_better(best.rotated(Int4{2, 0, 1, 3}));
    return best;
  }

 private:
  FourOffers rotated(Int4 lanes) const {
    return {__builtin_shuffle(mean_m, lanes), __builtin_shuffle(distance_m, lanes)};
  }
};

/// Marks the pixels of a row that are open and have a source in the 3x3 pixels around them.
FACET_CPU_CLONES void mark_beside(const float* source, int pitch, const std::uint8_t* open, int width,
                                  std::uint8_t* marked) {
  for (int x = 0; x < width; ++x) {
    float largest = 0;
    FACET_UNROLL for (int dy = -1; dy <= 1; ++dy) FACET_UNROLL for (int dx = -1; dx <= 1; ++dx) {
      const float z = source[dy * pitch + x + dx];
      largest = z > largest ? z : largest;
    }
    marked[x] = (largest > 0) & (open[x] != 0);
  }
}

}  // namespace

void FillGrid::resize(Size size) {
  const int pitch = size.width + 2 * pad;
  const auto count = static_cast<std::size_t>(pitch) * static_cast<std::size_t>(size.height + 2 * pad) + 4;
  if (size != size_) {
    size_ = size;
    pitch_ = pitch;
    for (int i = 0; i < 8; ++i) offsets_[i] = neighbour8(i).dy * pitch + neighbour8(i).dx;
    source_.assign(count, 0);
    mean_m_.resize(count);
    distance_m_.resize(count);
  }
  open_.assign(count, 0);
  listed_in_.assign(count, 0);
  pass_ = 0;
}

void FillGrid::list_open_beside_sources(std::vector<int>& list) {
  list.clear();
  marked_.resize(static_cast<std::size_t>(size_.width));
  for (int y = 0; y < size_.height; ++y) {
    mark_beside(source_.data() + index(0, y), pitch_, open_.data() + index(0, y), size_.width,
                marked_.data());
    for_each_set_in_row(marked_.data(), size_.width, [&](int x) { list.push_back(index(x, y)); });
  }
}

/// Without branches, which would be guessed wrong: whatever is looked at is written, and counted or not.
void FillGrid::list_sources_beside(const std::vector<int>& pixels) {
  sources_.resize(8 * pixels.size());
  std::size_t count = 0;
  for (const int pixel : pixels)
    for (const int offset : offsets_) {
      const auto at = static_cast<std::size_t>(pixel + offset);
      sources_[count] = pixel + offset;
      count += (source_[at] > 0) & (listed_in_[at] != pass_);
      listed_in_[at] = pass_;
    }
  sources_.resize(count);
}

void FillGrid::list_open_beside(const std::vector<int>& pixels, std::vector<int>& list) {
  list.resize(8 * pixels.size());
  std::size_t count = 0;
  for (const int pixel : pixels)
    for (const int offset : offsets_) {
      std::uint8_t& state = open_[static_cast<std::size_t>(pixel + offset)];
      list[count] = pixel + offset;
      count += state == 1;
      state = state == 1 ? 2 : state;
    }
  list.resize(count);
}

/// The nine windows that contain the source, a row of three at a time: lane k of a row of windows is the one
/// around the pixel k - 1 to the right, lane 3 is not used. Columns are summed downwards, then across, as in
/// FillCandidate.
inline void FillGrid::take_offer(int source) {
  const float* at = source_.data() + source;
  FourOffers best;
  FACET_UNROLL for (int dy = -1; dy <= 1; ++dy) {
    const float* centre = at + dy * pitch_;
    Float4 sum{};
    Int4 count{};
    FACET_UNROLL for (int dx = -2; dx <= 0; ++dx) {
      const Float4 above = load(centre + dx - pitch_), row = load(centre + dx),
                   below = load(centre + dx + pitch_);
      sum += above + row + below;
      count -= (above > 0) + (row > 0) + (below > 0);  // true is -1
    }
    const Float4 mean = sum / __builtin_convertvector(count, Float4);
    const Float4 step = mean - *at;
    best.take_better({mean, step < 0 ? -step : step});
  }
  best = best.best_of_three();
  mean_m_[static_cast<std::size_t>(source)] = best.mean_m[0];
  distance_m_[static_cast<std::size_t>(source)] = best.distance_m[0];
}

/// Looks at a row of three sources at a time; only sources have an offer.
inline float FillGrid::best_mean(int pixel) const {
  FourOffers best;
  FACET_UNROLL for (int dy = -1; dy <= 1; ++dy) {
    const int at = pixel + dy * pitch_ - 1;
    const Float4 distance = load(distance_m_.data() + at);
    best.take_better(
        {load(mean_m_.data() + at), load(source_.data() + at) > 0 ? distance : FourOffers{}.distance_m});
  }
  return best.best_of_three().mean_m[0];
}

FACET_CPU_CLONES void FillGrid::propose(const std::vector<int>& pixels, std::vector<float>& means_m) {
  ++pass_;
  list_sources_beside(pixels);
  for (const int source : sources_) take_offer(source);
  means_m.resize(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) means_m[i] = best_mean(pixels[i]);
}

}  // namespace facet
