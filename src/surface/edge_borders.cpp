#include "surface/edge_borders.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "core/clones.hpp"

namespace facet {
namespace {

/// Directions, counterclockwise from the right.
constexpr std::array<int, 8> dx{1, 1, 0, -1, -1, -1, 0, 1};
constexpr std::array<int, 8> dy{0, -1, -1, -1, 0, 1, 1, 1};

constexpr unsigned opposite(unsigned direction) {
  return direction ^ 4;
}

/// Where a border goes on, by the neighbours of a pixel and the direction to the pixel before: the first set
/// neighbour counterclockwise from there. Without a table every step would be guessed wrong.
struct NextDirection {
  std::uint8_t of[256][8];

  constexpr NextDirection() : of{} {
    for (unsigned neighbours = 0; neighbours < 256; ++neighbours)
      for (unsigned from = 0; from < 8; ++from) {
        unsigned to = (from + 1) & 7;
        while (to != from && !(neighbours >> to & 1)) to = (to + 1) & 7;
        of[neighbours][from] = static_cast<std::uint8_t>(to);
      }
  }
};
constexpr NextDirection next_direction;

FACET_CPU_CLONES void find_neighbours_of_row(const std::uint8_t* set, int pitch, int width,
                                             std::uint8_t* neighbours) {
#pragma GCC ivdep
  for (int x = 0; x < width; ++x) {
    unsigned code = 0;
    FACET_UNROLL for (std::size_t i = 0; i < 8; ++i) code |=
        static_cast<unsigned>(set[x + dx[i] + dy[i] * pitch]) << i;
    neighbours[x] = static_cast<std::uint8_t>(code);
  }
}

}  // namespace

void EdgeBorders::follow(ImageView<const std::uint8_t> mask) {
  borders_.clear();
  points_.clear();
  find_neighbours(mask);
  marks_.assign(set_.size(), 0);
  for (int y = 0; y < mask.height; ++y) scan_row(y);
}

void EdgeBorders::find_neighbours(ImageView<const std::uint8_t> mask) {
  width_ = mask.width;
  pitch_ = mask.width + 2;
  const auto count = static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(mask.height + 2);
  set_.assign(count + sizeof(std::uint64_t), 0);  // rows are read a word at a time
  neighbours_.resize(count);
  for (int y = 0; y < mask.height; ++y) std::copy_n(mask.row(y), mask.width, set_.begin() + place(0, y));
  for (int y = 0; y < mask.height; ++y)
    find_neighbours_of_row(set_.data() + place(0, y), pitch_, mask.width, neighbours_.data() + place(0, y));
}

/// Visits the ends of a row's runs. Eight pixels at a time are passed over where nothing changes.
void EdgeBorders::scan_row(int y) {
  static_assert(std::endian::native == std::endian::little);
  const int first = place(0, y), behind = first + width_ + 1;
  int left_end = 0, right_end = 0;  // of the last run; 0 = none
  for (int i = first; i < behind; i += 8) {
    std::uint64_t here, before;
    std::memcpy(&here, set_.data() + i, sizeof here);
    std::memcpy(&before, set_.data() + i - 1, sizeof before);
    for (std::uint64_t changes = here ^ before; changes != 0; changes &= changes - 1) {
      const int pixel = i + std::countr_zero(changes) / 8;
      if (pixel >= behind) return;  // the next row's
      if (set_[static_cast<std::size_t>(pixel)]) {
        visit_left_end(pixel, right_end);
        left_end = pixel;
      } else {
        right_end = pixel - 1;
        visit_right_end(right_end, left_end);
      }
    }
  }
}

/// An outer border is met first at a pixel that no border has passed. What lies left of it belongs to the
/// border that ends the run before.
void EdgeBorders::visit_left_end(int pixel, int before) {
  if (marks_[static_cast<std::size_t>(pixel)] != 0) return;
  int parent = -1;
  if (before != 0) {
    parent = std::abs(marks_[static_cast<std::size_t>(before)]) - 1;
    const EdgeBorder& beside = borders_[static_cast<std::size_t>(parent)];
    if (!beside.is_hole) parent = beside.parent;
  }
  follow_border(pixel, false, parent);
}

/// The border of a hole is met first at a pixel whose right side no border has passed. The run's left end is
/// on a border of the same component.
void EdgeBorders::visit_right_end(int pixel, int left_end) {
  if (marks_[static_cast<std::size_t>(pixel)] < 0) return;
  const int beside = std::abs(marks_[static_cast<std::size_t>(left_end)]) - 1;
  const EdgeBorder& border = borders_[static_cast<std::size_t>(beside)];
  follow_border(pixel, true, border.is_hole ? border.parent : beside);
}

void EdgeBorders::follow_border(int start, bool is_hole, int parent) {
  ContourPoint p{start % pitch_ - 1, start / pitch_ - 1};
  const int number = static_cast<int>(borders_.size()) + 1;
  borders_.push_back({p, is_hole, parent, points_.size(), 0});
  const unsigned around = neighbours_[static_cast<std::size_t>(start)];
  if (around == 0) {
    marks_[static_cast<std::size_t>(start)] = -number;
    points_.push_back(p);
    borders_.back().end = points_.size();
    return;
  }
  unsigned from = is_hole ? 7 : 3;  // the first set neighbour clockwise from the clear one
  while (!(around >> from & 1)) from = (from - 1) & 7;
  std::array<int, 8> step;
  for (std::size_t i = 0; i < 8; ++i) step[i] = dx[i] + dy[i] * pitch_;
  const int last = start + step[from];
  for (int pixel = start;;) {
    const unsigned to = next_direction.of[neighbours_[static_cast<std::size_t>(pixel)]][from];
    const bool passes_right = to - 1 < from;  // which is clear
    std::int32_t& mark = marks_[static_cast<std::size_t>(pixel)];
    mark = passes_right ? -number : (mark == 0 ? number : mark);
    points_.push_back(p);
    const int next = pixel + step[to];
    if (next == start && pixel == last) break;
    p = {p.x + dx[to], p.y + dy[to]};
    pixel = next;
    from = opposite(to);
  }
  borders_.back().end = points_.size();
}

}  // namespace facet
