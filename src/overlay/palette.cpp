#include "overlay/palette.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <set>
#include <vector>

namespace facet {
namespace {

constexpr int neighbour_distance_px = 4;

struct Neighbourhood {
  int area_px = 0;
  std::set<int> labels{};
};

std::map<int, Neighbourhood> neighbourhoods(const Image<std::uint16_t>& labels) {
  std::map<int, Neighbourhood> found;
  const auto connect = [&](int a, int x, int y) {
    if (!labels.size().contains(x, y)) return;
    const int b = labels(x, y);
    if (b == 0 || a == b) return;
    found[a].labels.insert(b);
    found[b].labels.insert(a);
  };
  for (int y = 0; y < labels.height(); ++y) {
    for (int x = 0; x < labels.width(); ++x) {
      const int label = labels(x, y);
      if (label == 0) continue;
      ++found[label].area_px;
      for (int d = 1; d <= neighbour_distance_px; ++d) {
        connect(label, x + d, y);
        connect(label, x, y + d);
      }
    }
  }
  return found;
}

/// How much two colours of the palette are mistaken for each other: large where they are the same, and a few
/// uses of a colour elsewhere in the picture where they are alike.
double likeness(std::size_t a, std::size_t b) {
  constexpr double same = 3e5;
  return same / (1 + std::pow(cv::norm(surface_palette[a] - surface_palette[b]), 2));
}

}  // namespace

std::map<int, cv::Scalar> surface_colors(const Image<std::uint16_t>& labels) {
  const auto regions = neighbourhoods(labels);
  std::vector<int> order;
  for (const auto& [label, region] : regions) order.push_back(label);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return regions.at(a).labels.size() > regions.at(b).labels.size(); });
  std::map<int, std::size_t> choice;
  std::array<double, surface_palette.size()> uses{};
  constexpr double large = 30;  // a surface that fills the picture keeps its colour to itself
  for (const int label : order) {
    std::array<double, surface_palette.size()> cost = uses;
    for (const int neighbour : regions.at(label).labels)
      if (const auto chosen = choice.find(neighbour); chosen != choice.end())
        for (std::size_t i = 0; i < cost.size(); ++i) cost[i] += likeness(i, chosen->second);
    choice[label] = static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
    uses[choice[label]] += 1 + large * regions.at(label).area_px / static_cast<double>(labels.size().area());
  }
  std::map<int, cv::Scalar> colors;
  for (const auto& [label, index] : choice) colors[label] = surface_palette[index];
  return colors;
}

}  // namespace facet
