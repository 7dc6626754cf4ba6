#include "synth/outline.hpp"

#include <algorithm>
#include <climits>

namespace facet {
namespace {

/// Corner of a pixel: corner (x, y) is the upper left one of pixel (x, y).
struct Corner {
  int x = 0, y = 0;
  friend bool operator==(const Corner&, const Corner&) = default;
};
using Loop = std::vector<Corner>;

/// Directions right, down, left, up; borders run with the region on their right.
constexpr int step_x[] = {1, 0, -1, 0}, step_y[] = {0, 1, 0, -1};

struct Region {
  const Image<std::uint16_t>& ids;
  std::uint16_t id;
  bool operator()(int x, int y) const { return ids.size().contains(x, y) && ids(x, y) == id; }
  /// A border leaves the corner in this direction: inside on its right, outside on its left.
  bool border(Corner c, int direction) const {
    switch (direction) {
      case 0:
        return (*this)(c.x, c.y) && !(*this)(c.x, c.y - 1);
      case 1:
        return (*this)(c.x - 1, c.y) && !(*this)(c.x, c.y);
      case 2:
        return (*this)(c.x - 1, c.y - 1) && !(*this)(c.x - 1, c.y);
      default:
        return (*this)(c.x, c.y - 1) && !(*this)(c.x - 1, c.y - 1);
    }
  }
};

/// Follows the border that leaves `start` to the right until it closes, turning right first, so that pixels
/// which touch by a corner stay apart. Marks its rightward steps.
Loop follow(const Region& region, Corner start, Image<std::uint8_t>& marked) {
  Loop loop;
  Corner at = start;
  int direction = 0;
  do {
    loop.push_back(at);
    if (direction == 0) marked(at.x, at.y) = 1;
    at = {at.x + step_x[direction], at.y + step_y[direction]};
    for (const int turn : {1, 0, 3}) {
      const int next = (direction + turn) % 4;
      if (!region.border(at, next)) continue;
      direction = next;
      break;
    }
  } while (!(at == start && direction == 0));
  return loop;
}

/// Positive for outlines, negative for holes.
long signed_area(const Loop& loop) {
  long sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Corner a = loop[i], b = loop[(i + 1) % loop.size()];
    sum += static_cast<long>(a.x) * b.y - static_cast<long>(b.x) * a.y;
  }
  return sum;
}

/// Joins the hole to the loop with the nearest corner to the left of the hole's leftmost corner.
void cut_open(std::vector<Loop>& loops, Loop hole) {
  const auto leftmost =
      std::min_element(hole.begin(), hole.end(), [](Corner a, Corner b) { return a.x < b.x; });
  std::rotate(hole.begin(), leftmost, hole.end());
  hole.push_back(hole.front());
  Loop* target = nullptr;
  std::size_t place = 0;
  int nearest = INT_MIN;
  for (Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop[i].y != hole.front().y || loop[i].x >= hole.front().x || loop[i].x <= nearest) continue;
      nearest = loop[i].x;
      target = &loop;
      place = i;
    }
  }
  hole.push_back((*target)[place]);
  target->insert(target->begin() + static_cast<std::ptrdiff_t>(place) + 1, hole.begin(), hole.end());
}

ImagePath simplified(const Loop& loop) {
  ImagePath path;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Corner a = loop[(i + n - 1) % n], b = loop[i], c = loop[(i + 1) % n];
    const bool straight = (b.x - a.x) * (c.y - b.y) == (b.y - a.y) * (c.x - b.x) &&
                          (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) > 0;
    if (!straight) path.push_back({b.x - 0.5, b.y - 0.5});
  }
  return path;
}

}  // namespace

std::vector<ImagePath> outlines(const Image<std::uint16_t>& ids, std::uint16_t id) {
  const Region region{ids, id};
  Image<std::uint8_t> marked({ids.width() + 1, ids.height() + 1});
  std::vector<Loop> loops, holes;
  for (int y = 0; y <= ids.height(); ++y) {
    for (int x = 0; x < ids.width(); ++x) {
      if (marked(x, y) != 0 || !region.border({x, y}, 0)) continue;
      Loop loop = follow(region, {x, y}, marked);
      (signed_area(loop) > 0 ? loops : holes).push_back(std::move(loop));
    }
  }
  const auto left = [](const Loop& loop) {
    return std::min_element(loop.begin(), loop.end(), [](Corner a, Corner b) { return a.x < b.x; })->x;
  };
  std::sort(holes.begin(), holes.end(), [&](const Loop& a, const Loop& b) { return left(a) < left(b); });
  for (Loop& hole : holes) cut_open(loops, std::move(hole));
  std::vector<ImagePath> paths;
  for (const Loop& loop : loops) paths.push_back(simplified(loop));
  return paths;
}

}  // namespace facet
