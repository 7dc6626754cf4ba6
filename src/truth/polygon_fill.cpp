#include "truth/polygon_fill.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace facet {
namespace {

/// x where the side from a to b crosses the row; the same whichever end comes first.
double crossing(ImagePoint a, ImagePoint b, double y) {
  if (b.y < a.y) std::swap(a, b);
  return a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
}

std::vector<double> crossings(const ImagePath& polygon, double y) {
  std::vector<double> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ImagePoint a = polygon[i], b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    if ((a.y <= y) != (b.y <= y)) out.push_back(crossing(a, b, y));
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

void for_each_span(const ImagePath& polygon, Size size, const std::function<void(int, int, int)>& visit) {
  if (polygon.empty()) return;
  const auto [top, bottom] = std::minmax_element(polygon.begin(), polygon.end(),
                                                 [](ImagePoint a, ImagePoint b) { return a.y < b.y; });
  const auto first = [](double v, int end) {
    return static_cast<int>(std::clamp(std::ceil(v), 0.0, static_cast<double>(end)));
  };
  for (int y = first(top->y, size.height); y < first(bottom->y, size.height); ++y) {
    const std::vector<double> x = crossings(polygon, y);
    for (std::size_t i = 0; i + 1 < x.size(); i += 2) {
      const int x0 = first(x[i], size.width), x1 = first(x[i + 1], size.width);
      if (x0 < x1) visit(y, x0, x1);
    }
  }
}

}  // namespace facet
