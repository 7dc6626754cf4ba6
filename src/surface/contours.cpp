#include "surface/contours.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <span>
#include <utility>

namespace facet {
namespace {

Polyline to_polyline(const std::vector<cv::Point>& points) {
  Polyline line;
  line.reserve(points.size());
  for (const cv::Point& p : points) line.push_back({p.x, p.y});
  return line;
}

/// cv::findContours' hierarchy: {next, previous, first child, parent}, -1 = none.
int parent_of(const cv::Vec4i& node) {
  return node[3];
}

bool encloses(const Polyline& hole, ContourPoint p) {
  std::vector<cv::Point> polygon;
  polygon.reserve(hole.size());
  for (const ContourPoint& q : hole) polygon.emplace_back(q.x, q.y);
  return cv::pointPolygonTest(polygon, cv::Point2f(static_cast<float>(p.x), static_cast<float>(p.y)), false) >
         0;
}

PixelBox box_of(const Polyline& line) {
  PixelBox box;
  for (const ContourPoint& p : line) box.add(p.x, p.y);
  return box;
}

/// The boxes around the holes of every surface, in order; each surface's begin at its own index.
struct HoleBoxes {
  std::vector<PixelBox> boxes;
  std::vector<std::size_t> begin;

  explicit HoleBoxes(const std::vector<Surface>& surfaces) {
    for (const Surface& surface : surfaces) {
      begin.push_back(boxes.size());
      for (const Polyline& hole : surface.contour.holes) boxes.push_back(box_of(hole));
    }
  }
};

bool has_hole_around(const Surface& surface, const PixelBox* boxes, ContourPoint p) {
  for (std::size_t i = 0; i < surface.contour.holes.size(); ++i) {
    const PixelBox& box = boxes[i];
    if (p.x > box.x0 && p.x < box.x1 && p.y > box.y0 && p.y < box.y1 && encloses(surface.contour.holes[i], p))
      return true;
  }
  return false;
}

/// The label next to the left of a pixel, past pixels without one; 0 = none up to the image's edge.
int label_to_the_left(ImageView<const std::uint16_t> labels, ContourPoint p) {
  for (int x = p.x - 1; x >= 0; --x)
    if (labels(x, p.y) != 0) return labels(x, p.y);
  return 0;
}

/// As in Suzuki and Abe's scan: the surface met last, to the left of a surface's first pixel, either has it
/// in a hole, and is its parent, or lies in the same hole. The first pixels are taken in raster order, so
/// that the left one's parent is known.
void find_parents(ImageView<const std::uint16_t> labels, std::vector<Surface>& surfaces) {
  std::vector<Surface*> order;
  for (Surface& surface : surfaces)
    if (!surface.contour.outer.empty()) order.push_back(&surface);
  const auto first = [](const Surface* s) { return s->contour.outer.front(); };
  std::sort(order.begin(), order.end(), [&](const Surface* a, const Surface* b) {
    return std::pair(first(a).y, first(a).x) < std::pair(first(b).y, first(b).x);
  });
  const HoleBoxes holes(surfaces);
  for (Surface* surface : order) {
    const int left = label_to_the_left(labels, first(surface));
    if (left == 0 || left == surface->id) continue;
    const auto index = static_cast<std::size_t>(left) - 1;
    const Surface& neighbour = surfaces[index];
    const bool inside = has_hole_around(neighbour, holes.boxes.data() + holes.begin[index], first(surface));
    surface->parent = inside ? neighbour.id : neighbour.parent;
  }
}

void list_children(std::vector<Surface>& surfaces) {
  for (const Surface& surface : surfaces)
    if (surface.parent != 0)
      surfaces[static_cast<std::size_t>(surface.parent) - 1].children.push_back(surface.id);
}

}  // namespace

void PixelBox::add(int x, int y) {
  if (empty()) {
    *this = {x, y, x, y};
    return;
  }
  x0 = std::min(x0, x), x1 = std::max(x1, x);
  y0 = std::min(y0, y), y1 = std::max(y1, y);
}

void trace_regions(ImageView<const std::uint16_t> labels, const std::vector<PixelBox>& boxes,
                   std::vector<Surface>& surfaces) {
  const cv::Mat map(labels.height, labels.width, CV_16U, const_cast<std::uint16_t*>(labels.data),
                    static_cast<std::size_t>(labels.stride) * sizeof(std::uint16_t));
  cv::Mat mask;
  std::vector<std::vector<cv::Point>> lines;
  std::vector<cv::Vec4i> hierarchy;
  for (Surface& surface : surfaces) {
    const PixelBox& box = boxes[static_cast<std::size_t>(surface.id) - 1];
    if (box.empty()) continue;
    cv::compare(map(cv::Rect(box.x0, box.y0, box.x1 - box.x0 + 1, box.y1 - box.y0 + 1)), surface.id, mask,
                cv::CMP_EQ);
    cv::findContours(mask, lines, hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE, {box.x0, box.y0});
    int widest = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const int extent = cv::boundingRect(lines[i]).area();
      if (parent_of(hierarchy[i]) >= 0) {
        surface.contour.holes.push_back(to_polyline(lines[i]));
      } else if (extent > widest) {
        widest = extent;
        surface.contour.outer = to_polyline(lines[i]);
      }
    }
  }
  find_parents(labels, surfaces);
  list_children(surfaces);
}

void trace_edge_map(const EdgeBorders& edge_borders, ImageView<const std::uint16_t> labels,
                    std::vector<Surface>& surfaces) {
  const std::span<const EdgeBorder> borders = edge_borders.borders();
  const auto label_in = [&](int border) -> int {  // at the hole's first pixel, 0 where it is no surface
    if (border < 0 || !borders[static_cast<std::size_t>(border)].is_hole) return 0;
    const ContourPoint start = borders[static_cast<std::size_t>(border)].start;
    return labels(start.x + 1, start.y);
  };
  for (std::size_t i = borders.size(); i-- > 0;) {
    const EdgeBorder& border = borders[i];
    const int owner = border.is_hole ? label_in(static_cast<int>(i)) : label_in(border.parent);
    if (owner == 0) continue;
    Surface& surface = surfaces[static_cast<std::size_t>(owner) - 1];
    const std::span<const ContourPoint> points = edge_borders.points(border);
    if (!border.is_hole) {
      surface.contour.holes.emplace_back(points.begin(), points.end());
      continue;
    }
    surface.contour.outer.assign(points.begin(), points.end());
    surface.parent = label_in(borders[static_cast<std::size_t>(border.parent)].parent);
  }
  list_children(surfaces);
}

}  // namespace facet
