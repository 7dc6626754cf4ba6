#pragma once

namespace facet {

/// A proportion as counted: `hit` of `n`.
struct Tally {
  int hit = 0;
  int n = 0;

  void add(bool is_hit) {
    ++n;
    if (is_hit) ++hit;
  }
  friend bool operator==(const Tally&, const Tally&) = default;
};

}  // namespace facet
