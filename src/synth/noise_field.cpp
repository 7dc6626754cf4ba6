#include "synth/noise_field.hpp"

#include <cmath>
#include <vector>

#include "core/random.hpp"

namespace facet {
namespace {

/// out[i] = in[i] + ... + in[i + window - 1] for i < n.
void running_sum(const float* in, float* out, int n, int window) {
  double sum = 0;
  for (int i = 0; i < window - 1; ++i) sum += in[i];
  for (int i = 0; i < n; ++i) {
    sum += in[i + window - 1];
    out[i] = static_cast<float>(sum);
    sum -= in[i];
  }
}

}  // namespace

float random_normal(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  const std::uint64_t bits = random_bits(seed, stream, index);
  const float u = (static_cast<float>(bits >> 40) + 0.5f) * (1.0f / 16777216.0f);
  const float v = static_cast<float>(bits & 0xFFFFFF) * (1.0f / 16777216.0f);
  return std::sqrt(-2.0f * std::log(u)) * std::cos(6.2831853f * v);
}

Image<float> noise_field(Size size, int window_px, std::uint64_t seed, std::uint64_t stream) {
  const int margin = window_px - 1;
  const Size wide{size.width + margin, size.height + margin};
  Image<float> rows({size.width, wide.height});
  std::vector<float> white(wide.width);
  for (int y = 0; y < wide.height; ++y) {
    const std::uint64_t first = static_cast<std::uint64_t>(y) * wide.width;
    for (int x = 0; x < wide.width; ++x) white[x] = random_normal(seed, stream, first + x);
    running_sum(white.data(), rows.row(y), size.width, window_px);
  }
  Image<float> field(size);
  std::vector<float> column(wide.height), sums(size.height);
  const float scale = 1.0f / static_cast<float>(window_px);
  for (int x = 0; x < size.width; ++x) {
    for (int y = 0; y < wide.height; ++y) column[y] = rows(x, y);
    running_sum(column.data(), sums.data(), size.height, window_px);
    for (int y = 0; y < size.height; ++y) field(x, y) = scale * sums[y];
  }
  return field;
}

}  // namespace facet
