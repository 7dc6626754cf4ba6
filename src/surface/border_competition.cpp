#include "surface/border_competition.hpp"

#include <array>

#include "core/changes.hpp"
#include "core/neighbours.hpp"

namespace facet {
namespace {

/// Readings are compared over a square around a pixel: one alone is noise.
constexpr int window_radius_px = 1;

template <class Visit>
void for_each_neighbour4(Size size, int pixel, const Visit& visit) {
  const int x = pixel % size.width, y = pixel / size.width;
  for (int i = 0; i < 8; i += 2) {
    const auto [dx, dy] = neighbour8(i);
    if (size.contains(x + dx, y + dy)) visit(x + dx, y + dy);
  }
}

/// The readings around a pixel that are in a region: place relative to the principal point [px] and q [1/m].
struct Readings {
  static constexpr int most = (2 * window_radius_px + 1) * (2 * window_radius_px + 1);
  int count = 0;
  double u[most], v[most], q[most];

  Readings(const BasinLandscape& landscape, ImageView<const std::int32_t> region, int x, int y) {
    for (int py = y - window_radius_px; py <= y + window_radius_px; ++py)
      for (int px = x - window_radius_px; px <= x + window_radius_px; ++px) {
        if (!region.size().contains(px, py) || region(px, py) < 0) continue;
        u[count] = px - double{landscape.camera.cx}, v[count] = py - double{landscape.camera.cy};
        q[count++] = landscape.q(px, py);
      }
  }
  /// Mean of their squared distances from a patch [1/m^2].
  double mean_square(const PatchFit& patch) const {
    double sum = 0;
    for (int i = 0; i < count; ++i) {
      const double distance = q[i] - patch.at(u[i], v[i]).q;
      sum += distance * distance;
    }
    return sum / count;
  }
};

/// The region whose patch explains a pixel best.
std::int32_t winner_at(const Competition& c, ImageView<const std::int32_t> region, int pixel) {
  const int x = pixel % region.width, y = pixel / region.width;
  const std::int32_t own = region(x, y);
  std::array<std::int32_t, 4> rivals;
  std::size_t count = 0;
  for_each_neighbour4(region.size(), pixel, [&](int nx, int ny) {
    if (region(nx, ny) >= 0 && region(nx, ny) != own) rivals[count++] = region(nx, ny);
  });
  if (own < 0 || count == 0) return own;
  const Readings readings(c.landscape, region, x, y);
  const auto square_of = [&](std::int32_t i) {
    return readings.mean_square(c.patches[static_cast<std::size_t>(i)]);
  };
  const double q = c.landscape.q(x, y);
  const double least_gain = c.sigmas * double{c.noise.sigma_m(static_cast<float>(1 / q))} * q * q;
  std::int32_t winner = own;
  double least = square_of(own) - least_gain * least_gain;
  for (const std::int32_t rival : std::span(rivals).first(count)) {
    const double square = square_of(rival);
    if (square < least) least = square, winner = rival;
  }
  return winner;
}

}  // namespace

void BorderCompetition::list(int pixel) {
  std::uint8_t& listed = listed_[static_cast<std::size_t>(pixel)];
  if (!listed) pixels_.push_back(pixel);
  listed = 1;
}

void BorderCompetition::list_border_pixels(ImageView<const std::int32_t> region) {
  pixels_.clear();
  listed_.assign(static_cast<std::size_t>(region.size().area()), 0);
  for_each_change(region, [&](int x, int y, bool down) {
    const int pixel = y * region.width + x;
    list(pixel);
    list(pixel + (down ? region.width : 1));
  });
}

void BorderCompetition::list_pixels_around_moves(Size size) {
  for (const int pixel : pixels_) listed_[static_cast<std::size_t>(pixel)] = 0;
  pixels_.clear();
  for (const Move& move : moves_) {
    list(move.pixel);
    for_each_neighbour4(size, move.pixel, [&](int x, int y) { list(y * size.width + x); });
  }
}

void BorderCompetition::run(const Competition& competition, int passes, ImageView<std::int32_t> region) {
  list_border_pixels(region);
  for (int pass = 0; pass < passes && !pixels_.empty(); ++pass) {
    moves_.clear();
    for (const int pixel : pixels_) {
      const std::int32_t winner = winner_at(competition, region, pixel);
      if (winner != region(pixel % region.width, pixel / region.width)) moves_.push_back({pixel, winner});
    }
    for (const Move& move : moves_)
      region(move.pixel % region.width, move.pixel / region.width) = move.region;
    list_pixels_around_moves(region.size());
  }
}

}  // namespace facet
