#include "cpu/fill_grid.hpp"

#include <algorithm>
#include <cstring>

#include "core/clones.hpp"
#include "core/sparse_row.hpp"

namespace facet {
namespace {

using Float4 = float __attribute__((vector_size(16)));
using Float8 = float __attribute__((vector_size(32)));
using Int8 = int __attribute__((vector_size(32)));

/// Four values at each of two places, side by side.
[[gnu::always_inline]] inline void load_two(const float* first, const float* second, Float8& values) {
  Float4 low, high;
  std::memcpy(&low, first, sizeof low);
  std::memcpy(&high, second, sizeof high);
  values = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

/// Offers for two pixels, four lanes each, compared as FillOffer does.
struct OffersForTwo {
  Float8 mean_m = Float8{}, distance_m = Float8{} + FillOffer{}.distance_m;

  [[gnu::always_inline]] void take_better(const Float8& other_mean_m, const Float8& other_distance_m) {
    const Int8 better =
        (other_distance_m < distance_m) | ((other_distance_m == distance_m) & (other_mean_m > mean_m));
    mean_m = better ? other_mean_m : mean_m;
    distance_m = better ? other_distance_m : distance_m;
  }
  /// Takes the best of each pixel's first three lanes into its first.
  [[gnu::always_inline]] void take_best_lane() {
    const OffersForTwo lanes = *this;
    take_better(__builtin_shufflevector(lanes.mean_m, lanes.mean_m, 1, 2, 0, 3, 5, 6, 4, 7),
                __builtin_shufflevector(lanes.distance_m, lanes.distance_m, 1, 2, 0, 3, 5, 6, 4, 7));
    take_better(__builtin_shufflevector(lanes.mean_m, lanes.mean_m, 2, 0, 1, 3, 6, 4, 5, 7),
                __builtin_shufflevector(lanes.distance_m, lanes.distance_m, 2, 0, 1, 3, 6, 4, 5, 7));
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
    for (int i = 0; i < 8; ++i)
      offsets_[static_cast<std::size_t>(i)] = neighbour8(i).dy * pitch + neighbour8(i).dx;
    source_.assign(count, 0);
  }
  open_.assign(count, 0);
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
void FillGrid::list_sources_beside(std::span<const int> pixels, FillOffers& offers) const {
  offers.sources.resize(8 * pixels.size() + 1);
  const std::array<int, 8> offsets = offsets_;
  const std::uint16_t pass = offers.pass;
  const float* source = source_.data();
  std::uint16_t* listed_in = offers.listed_in.data();
  int* end = offers.sources.data();
  for (const int pixel : pixels)
    for (const int offset : offsets) {
      const std::ptrdiff_t at = pixel + offset;
      *end = pixel + offset;
      end += (source[at] > 0) & (listed_in[at] != pass);
      listed_in[at] = pass;
    }
  offers.sources.resize(static_cast<std::size_t>(end - offers.sources.data()));
}

void FillGrid::list_open_beside(const std::vector<int>& pixels, std::vector<int>& list) {
  list.resize(8 * pixels.size() + 1);
  const std::array<int, 8> offsets = offsets_;
  std::uint8_t* open = open_.data();
  int* end = list.data();
  for (const int pixel : pixels)
    for (const int offset : offsets) {
      const std::uint8_t state = open[pixel + offset];
      *end = pixel + offset;
      end += state == 1;
      open[pixel + offset] = state == 1 ? std::uint8_t{2} : state;
    }
  list.resize(static_cast<std::size_t>(end - list.data()));
}

/// The nine windows that contain a source, a row of three at a time: lane k of a row of windows is the one
/// around the pixel k - 1 to the right, lane 3 is not used. Columns are summed downwards, then across, as in
/// FillCandidate.
[[gnu::always_inline]] inline void FillGrid::take_offers(int first, int second, FillOffers& offers) const {
  const float* source = source_.data();
  const std::ptrdiff_t pitch = pitch_;
  const Float8 depth_m = {source[first],  source[first],  source[first],  source[first],
                          source[second], source[second], source[second], source[second]};
  OffersForTwo best;
  FACET_UNROLL for (int dy = -1; dy <= 1; ++dy) {
    Float8 sum{};
    Int8 count{};
    FACET_UNROLL for (int dx = -2; dx <= 0; ++dx) {
      Float8 above, row, below;
      load_two(source + first + dx + (dy - 1) * pitch, source + second + dx + (dy - 1) * pitch, above);
      load_two(source + first + dx + dy * pitch, source + second + dx + dy * pitch, row);
      load_two(source + first + dx + (dy + 1) * pitch, source + second + dx + (dy + 1) * pitch, below);
      sum += above + row + below;
      count -= (above > 0) + (row > 0) + (below > 0);  // true is -1
    }
    const Float8 mean = sum / __builtin_convertvector(count, Float8);
    const Float8 step = mean - depth_m;
    best.take_better(mean, step < 0 ? -step : step);
  }
  best.take_best_lane();
  offers.mean_m[static_cast<std::size_t>(first)] = best.mean_m[0];
  offers.distance_m[static_cast<std::size_t>(first)] = best.distance_m[0];
  offers.mean_m[static_cast<std::size_t>(second)] = best.mean_m[4];
  offers.distance_m[static_cast<std::size_t>(second)] = best.distance_m[4];
}

/// Looks at a row of three sources at a time; only sources have an offer.
[[gnu::always_inline]] inline void FillGrid::find_best_means(const FillOffers& offers, int first, int second,
                                                             float& first_m, float& second_m) const {
  OffersForTwo best;
  FACET_UNROLL for (int dy = -1; dy <= 1; ++dy) {
    const std::ptrdiff_t a = first + dy * pitch_ - 1, b = second + dy * pitch_ - 1;
    Float8 source, mean, distance;
    load_two(source_.data() + a, source_.data() + b, source);
    load_two(offers.mean_m.data() + a, offers.mean_m.data() + b, mean);
    load_two(offers.distance_m.data() + a, offers.distance_m.data() + b, distance);
    best.take_better(mean, source > 0 ? distance : Float8{} + FillOffer{}.distance_m);
  }
  best.take_best_lane();
  first_m = best.mean_m[0];
  second_m = best.mean_m[4];
}

FACET_CPU_CLONES void FillGrid::propose(FillOffers& offers, std::span<const int> pixels,
                                        float* means_m) const {
  if (offers.listed_in.size() != source_.size()) {
    for (auto* values : {&offers.mean_m, &offers.distance_m}) values->resize(source_.size());
    offers.listed_in.assign(source_.size(), 0);
    offers.pass = 0;
  }
  if (++offers.pass == 0) {  // all numbers of passes have been used
    std::fill(offers.listed_in.begin(), offers.listed_in.end(), std::uint16_t{0});
    offers.pass = 1;
  }
  list_sources_beside(pixels, offers);
  const std::vector<int>& sources = offers.sources;
  for (std::size_t i = 0; i < sources.size(); i += 2)
    take_offers(sources[i], sources[std::min(i + 1, sources.size() - 1)], offers);
  for (std::size_t i = 0; i < pixels.size(); i += 2) {
    const std::size_t k = std::min(i + 1, pixels.size() - 1);
    find_best_means(offers, pixels[i], pixels[k], means_m[i], means_m[k]);
  }
}

}  // namespace facet
