#include "surface/border_competition.hpp"

#include <algorithm>
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

void BorderCompetition::list(int pixel, std::vector<int>& pixels) {
  std::uint8_t& listed = listed_[static_cast<std::size_t>(pixel)];
  if (!listed) pixels.push_back(pixel);
  listed = 1;
}

/// Every worker lists those of its own rows, so that it also looks at what changes from the row above.
void BorderCompetition::list_border_pixels(HostThreads& threads, ImageView<const std::int32_t> region) {
  listed_.assign(static_cast<std::size_t>(region.size().area()), 0);
  for (Part& part : parts_) part.pixels.clear();
  threads.for_each_part(
      static_cast<std::size_t>(region.height), 1, [&](std::size_t i, std::size_t begin, std::size_t end) {
        std::vector<int>& pixels = parts_[i].pixels;
        const int begin_y = static_cast<int>(begin), end_y = static_cast<int>(end);
        for_each_change(region, std::max(begin_y - 1, 0), end_y, [&](int x, int y, bool down) {
          const int pixel = y * region.width + x;
          if (y >= begin_y) list(pixel, pixels);
          if (y + (down ? 1 : 0) >= begin_y && y + (down ? 1 : 0) < end_y)
            list(pixel + (down ? region.width : 1), pixels);
        });
      });
  pixels_.clear();
  for (const Part& part : parts_) pixels_.insert(pixels_.end(), part.pixels.begin(), part.pixels.end());
}

void BorderCompetition::list_pixels_around_moves(Size size) {
  for (const int pixel : pixels_) listed_[static_cast<std::size_t>(pixel)] = 0;
  pixels_.clear();
  for (const Part& part : parts_)
    for (const Move& move : part.moves) {
      list(move.pixel, pixels_);
      for_each_neighbour4(size, move.pixel, [&](int x, int y) { list(y * size.width + x, pixels_); });
    }
}

void BorderCompetition::find_moves(HostThreads& threads, const Competition& competition,
                                   ImageView<const std::int32_t> region) {
  for (Part& part : parts_) part.moves.clear();
  constexpr std::size_t least_pixels = 1024;  // a tenth of a millisecond
  threads.for_each_part(pixels_.size(), least_pixels, [&](std::size_t i, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::int32_t winner = winner_at(competition, region, pixels_[k]);
      if (winner != region(pixels_[k] % region.width, pixels_[k] / region.width))
        parts_[i].moves.push_back({pixels_[k], winner});
    }
  });
}

void BorderCompetition::run(HostThreads& threads, const Competition& competition, int passes,
                            ImageView<std::int32_t> region) {
  parts_.resize(static_cast<std::size_t>(threads.workers()));
  list_border_pixels(threads, region);
  for (int pass = 0; pass < passes && !pixels_.empty(); ++pass) {
    find_moves(threads, competition, region);
    for (const Part& part : parts_)
      for (const Move& move : part.moves)
        region(move.pixel % region.width, move.pixel / region.width) = move.region;
    list_pixels_around_moves(region.size());
  }
}

}  // namespace facet
