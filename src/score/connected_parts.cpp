#include "score/connected_parts.hpp"

#include "core/neighbours.hpp"

namespace facet {
namespace {

constexpr std::int32_t unseen = -1;

/// Collects the part that holds the seed into `pixels`, marking it in the map.
void flood(const Image<std::uint16_t>& labels, Offset seed, std::int32_t mark, Image<std::int32_t>& map,
           std::vector<Offset>& pixels) {
  const std::uint16_t label = labels(seed.dx, seed.dy);
  pixels.assign(1, seed);
  map(seed.dx, seed.dy) = mark;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    for (const Offset step : {Offset{0, -1}, Offset{-1, 0}, Offset{1, 0}, Offset{0, 1}}) {
      const Offset p{pixels[i].dx + step.dx, pixels[i].dy + step.dy};
      if (!labels.size().contains(p.dx, p.dy) || labels(p.dx, p.dy) != label || map(p.dx, p.dy) != unseen)
        continue;
      map(p.dx, p.dy) = mark;
      pixels.push_back(p);
    }
  }
}

}  // namespace

ConnectedParts connected_parts(const Image<std::uint16_t>& labels, int least_px) {
  ConnectedParts out{Image<std::int32_t>(labels.size(), unseen), {}};
  std::vector<Offset> pixels;
  for (int y = 0; y < labels.height(); ++y) {
    for (int x = 0; x < labels.width(); ++x) {
      if (labels(x, y) == 0) out.map(x, y) = 0;
      if (out.map(x, y) != unseen) continue;
      flood(labels, {x, y}, static_cast<std::int32_t>(out.parts.size()) + 1, out.map, pixels);
      const int area_px = static_cast<int>(pixels.size());
      if (area_px >= least_px) {
        out.parts.push_back({labels(x, y), area_px});
      } else {
        for (const Offset p : pixels) out.map(p.dx, p.dy) = 0;
      }
    }
  }
  return out;
}

}  // namespace facet
