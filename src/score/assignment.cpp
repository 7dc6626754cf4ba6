#include "score/assignment.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace facet {
namespace {

/// Row given to each column, -1 = none, at the smallest total cost; rows <= columns, every row is given.
std::vector<int> cheapest_rows(const Eigen::MatrixXd& cost) {
  const auto rows = static_cast<int>(cost.rows()), columns = static_cast<int>(cost.cols());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> row_price(rows, 0.0), column_price(columns + 1, 0.0);
  std::vector<int> row_of(columns + 1, -1),
      came_from(columns + 1, 0);  // the last column stands for the start
  for (int row = 0; row < rows; ++row) {
    std::vector<double> slack(columns, infinity);
    std::vector<bool> seen(columns + 1, false);
    int at = columns;
    row_of[at] = row;
    while (row_of[at] >= 0) {  // grow the tree of cheapest paths until it meets a free column
      seen[at] = true;
      int next = -1;
      for (int c = 0; c < columns; ++c) {
        if (seen[c]) continue;
        const double reduced = cost(row_of[at], c) - row_price[row_of[at]] - column_price[c];
        if (reduced < slack[c]) slack[c] = reduced, came_from[c] = at;
        if (next < 0 || slack[c] < slack[next]) next = c;
      }
      const double step = slack[next];
      for (int c = 0; c <= columns; ++c) {
        if (seen[c]) {
          row_price[row_of[c]] += step;
          column_price[c] -= step;
        } else if (c < columns) {
          slack[c] -= step;
        }
      }
      at = next;
    }
    for (; at != columns; at = came_from[at]) row_of[at] = row_of[came_from[at]];
  }
  row_of.pop_back();
  return row_of;
}

/// Positions of the distinct values in sorted order.
std::map<int, int> positions(std::span<const WeightedPair> pairs, int WeightedPair::*side) {
  std::map<int, int> at;
  for (const WeightedPair& pair : pairs) at[pair.*side] = 0;
  int next = 0;
  for (auto& [value, position] : at) position = next++;
  return at;
}

void assign_part(std::span<const WeightedPair> pairs, std::vector<WeightedPair>& out) {
  if (pairs.size() == 1) {
    out.push_back(pairs[0]);
    return;
  }
  const auto row_at = positions(pairs, &WeightedPair::row),
             column_at = positions(pairs, &WeightedPair::column);
  const bool flip = row_at.size() > column_at.size();
  const std::size_t small = flip ? column_at.size() : row_at.size();
  const std::size_t large = flip ? row_at.size() : column_at.size();
  Eigen::MatrixXd cost = Eigen::MatrixXd::Zero(static_cast<int>(small), static_cast<int>(large));
  const auto place = [&](const WeightedPair& p) {
    const int r = row_at.at(p.row), c = column_at.at(p.column);
    return flip ? std::pair(c, r) : std::pair(r, c);
  };
  for (const WeightedPair& pair : pairs) cost(place(pair).first, place(pair).second) = -pair.weight;
  const std::vector<int> given = cheapest_rows(cost);
  for (const WeightedPair& pair : pairs) {
    const auto [r, c] = place(pair);
    if (given[static_cast<std::size_t>(c)] == r) out.push_back(pair);
  }
}

/// Sorts the pairs that can affect each other together and returns where each group starts.
std::vector<std::size_t> group_connected(std::vector<WeightedPair>& pairs) {
  const auto row_at = positions(pairs, &WeightedPair::row),
             column_at = positions(pairs, &WeightedPair::column);
  std::vector<int> root(row_at.size() + column_at.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int i) {
    while (root[static_cast<std::size_t>(i)] != i)
      i = root[static_cast<std::size_t>(i)] =
          root[static_cast<std::size_t>(root[static_cast<std::size_t>(i)])];
    return i;
  };
  const auto rows = static_cast<int>(row_at.size());
  for (const WeightedPair& p : pairs)
    root[static_cast<std::size_t>(find(row_at.at(p.row)))] = find(rows + column_at.at(p.column));
  const auto part = [&](const WeightedPair& p) { return find(row_at.at(p.row)); };
  std::stable_sort(pairs.begin(), pairs.end(),
                   [&](const WeightedPair& a, const WeightedPair& b) { return part(a) < part(b); });
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (i == 0 || part(pairs[i]) != part(pairs[i - 1])) starts.push_back(i);
  starts.push_back(pairs.size());
  return starts;
}

}  // namespace

std::vector<WeightedPair> best_assignment(std::span<const WeightedPair> pairs) {
  std::vector<WeightedPair> useful;
  for (const WeightedPair& pair : pairs)
    if (pair.weight > 0) useful.push_back(pair);
  std::vector<WeightedPair> out;
  const std::vector<std::size_t> starts = group_connected(useful);
  for (std::size_t i = 0; i + 1 < starts.size(); ++i)
    assign_part(std::span(useful).subspan(starts[i], starts[i + 1] - starts[i]), out);
  std::sort(out.begin(), out.end(),
            [](const WeightedPair& a, const WeightedPair& b) { return a.row < b.row; });
  return out;
}

}  // namespace facet
