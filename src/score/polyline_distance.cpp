#include "score/polyline_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "truth/truth.hpp"

namespace facet {
namespace {

double distance_to_segment(ImagePoint p, ImagePoint a, ImagePoint b) {
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const double t = squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

ImagePoint between(ImagePoint a, ImagePoint b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

void draw_segment(ImagePoint a, ImagePoint b, double reach_px, Image<float>& distance) {
  const int x0 = std::max(0, static_cast<int>(std::floor(std::min(a.x, b.x) - reach_px)));
  const int y0 = std::max(0, static_cast<int>(std::floor(std::min(a.y, b.y) - reach_px)));
  const int x1 = std::min(distance.width() - 1, static_cast<int>(std::ceil(std::max(a.x, b.x) + reach_px)));
  const int y1 = std::min(distance.height() - 1, static_cast<int>(std::ceil(std::max(a.y, b.y) + reach_px)));
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const double scale = squared > 0 ? 1 / squared : 0;
  for (int y = y0; y <= y1; ++y) {
    float* row = distance.row(y);
    for (int x = x0; x <= x1; ++x) {
      const double px = x - a.x, py = y - a.y;
      const double t = std::clamp((px * dx + py * dy) * scale, 0.0, 1.0);
      const double ex = px - t * dx, ey = py - t * dy;
      row[x] = std::min(row[x], static_cast<float>(std::sqrt(ex * ex + ey * ey)));
    }
  }
}

}  // namespace

ImagePath sample_line(const ImagePath& line) {
  ImagePath samples;
  double next = 0, start = 0;  // arc lengths of the next sample and of the segment's start
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    for (; next <= start + length + 1e-9 && length > 0; next += 1)
      samples.push_back(between(line[i - 1], line[i], (next - start) / length));
    start += length;
  }
  return samples;
}

double distance_px(ImagePoint point, const ImagePath& line) {
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i)
    distance = std::min(distance, distance_to_segment(point, line[i - 1], line[i]));
  return distance;
}

void draw_distance(const ImagePath& line, double reach_px, Image<float>& distance) {
  constexpr double piece_px = 16;  // short pieces have small boxes, however the line slants
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / piece_px)));
    for (int k = 0; k < pieces; ++k)
      draw_segment(between(line[i - 1], line[i], static_cast<double>(k) / pieces),
                   between(line[i - 1], line[i], (k + 1.0) / pieces), reach_px, distance);
  }
}

}  // namespace facet
