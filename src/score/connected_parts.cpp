#include "score/connected_parts.hpp"

#include <algorithm>

namespace facet {
namespace {

/// Pixels x0 <= x < x1 of a row with one label.
struct Run {
  int y, x0, x1;
  int label;
  int root;  ///< index of an earlier run of the same part, or its own
};

std::vector<Run> runs_of(const Image<std::uint16_t>& labels) {
  std::vector<Run> runs;
  for (int y = 0; y < labels.height(); ++y) {
    const std::uint16_t* row = labels.row(y);
    for (int x = 0, x1 = 0; x < labels.width(); x = x1) {
      while (x1 < labels.width() && row[x1] == row[x]) ++x1;
      if (row[x] != 0) runs.push_back({y, x, x1, row[x], static_cast<int>(runs.size())});
    }
  }
  return runs;
}

int find(std::vector<Run>& runs, int i) {
  const auto root = [&](int k) -> int& { return runs[static_cast<std::size_t>(k)].root; };
  while (root(i) != i) i = root(i) = root(root(i));
  return i;
}

/// Joins runs of neighbouring rows that touch; the earliest run of a part becomes its root.
void join_runs(std::vector<Run>& runs) {
  std::size_t above = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    while (above < i && (runs[above].y < runs[i].y - 1 ||
                         (runs[above].y == runs[i].y - 1 && runs[above].x1 <= runs[i].x0)))
      ++above;
    for (std::size_t k = above; k < i && runs[k].y == runs[i].y - 1 && runs[k].x0 < runs[i].x1; ++k) {
      if (runs[k].label != runs[i].label) continue;
      const int a = find(runs, static_cast<int>(k)), b = find(runs, static_cast<int>(i));
      runs[static_cast<std::size_t>(std::max(a, b))].root = std::min(a, b);
    }
  }
}

}  // namespace

ConnectedParts connected_parts(const Image<std::uint16_t>& labels, int least_px) {
  std::vector<Run> runs = runs_of(labels);
  join_runs(runs);
  std::vector<int> area_px(runs.size(), 0);
  for (std::size_t i = 0; i < runs.size(); ++i)
    area_px[static_cast<std::size_t>(find(runs, static_cast<int>(i)))] += runs[i].x1 - runs[i].x0;
  ConnectedParts out{Image<std::int32_t>(labels.size(), 0), {}};
  std::vector<std::int32_t> mark(runs.size(), 0);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto root = static_cast<std::size_t>(find(runs, static_cast<int>(i)));
    if (area_px[root] < least_px) continue;
    if (root == i) {
      out.parts.push_back({runs[i].label, area_px[i]});
      mark[i] = static_cast<std::int32_t>(out.parts.size());
    }
    std::int32_t* row = out.map.row(runs[i].y);
    std::fill(row + runs[i].x0, row + runs[i].x1, mark[root]);
  }
  return out;
}

}  // namespace facet
