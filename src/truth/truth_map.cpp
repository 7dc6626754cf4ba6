#include "truth/truth_map.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "truth/polygon_fill.hpp"

namespace facet {
namespace {

struct ListedPolygon {
  const TruthPolygon* polygon = nullptr;
  std::uint16_t label = 0;
};

Image<std::uint16_t> surface_labels(const Truth& truth) {
  std::vector<ListedPolygon> polygons;
  for (std::size_t k = 0; k < truth.surfaces.size(); ++k) {
    for (const TruthPolygon& part : truth.surfaces[k].parts) {
      polygons.push_back({&part, static_cast<std::uint16_t>(k + 1)});
    }
  }
  std::sort(polygons.begin(), polygons.end(), [](const ListedPolygon& a, const ListedPolygon& b) {
    return a.polygon->order > b.polygon->order;  // the first listed is drawn last
  });
  Image<std::uint16_t> labels(truth.size, 0);
  for (const ListedPolygon& listed : polygons) {
    for_each_span(listed.polygon->path, truth.size, [&](int y, int x0, int x1) {
      std::fill(labels.row(y) + x0, labels.row(y) + x1, listed.label);
    });
  }
  return labels;
}

Image<std::uint8_t> mask_of(const std::vector<TruthPolygon>& polygons, Size size) {
  Image<std::uint8_t> mask(size, 0);
  for (const TruthPolygon& polygon : polygons) {
    for_each_span(polygon.path, size, [&](int y, int x0, int x1) {
      std::fill(mask.row(y) + x0, mask.row(y) + x1, std::uint8_t{1});
    });
  }
  return mask;
}

void require_size(Size size, Size expected, const char* what) {
  if (!size.empty() && size != expected)
    throw Error(ErrorKind::data, std::string(what) + ": size differs from the truth");
}

/// Sets the region of every pixel, and takes void pixels out of the label map.
void classify(const Truth& truth, const Image<std::uint16_t>& object_masks, const Image<float>& depth_m,
              TruthMap& map) {
  const Image<std::uint8_t> support = mask_of(truth.support, truth.size),
                            ignore = mask_of(truth.ignore, truth.size);
  for (int y = 0; y < truth.size.height; ++y) {
    for (int x = 0; x < truth.size.width; ++x) {
      const bool on_surface = map.surfaces(x, y) != 0, on_support = support(x, y) != 0;
      const bool uncovered = !object_masks.empty() && object_masks(x, y) != 0 && !on_surface;
      const bool no_depth = !depth_m.empty() && depth_m(x, y) == 0 && !on_surface && !on_support;
      if (ignore(x, y) != 0 || uncovered || no_depth) {
        map.regions(x, y) = TruthRegion::ignored;
        map.surfaces(x, y) = 0;
      } else {
        map.regions(x, y) = on_surface   ? TruthRegion::surface
                            : on_support ? TruthRegion::support
                                         : TruthRegion::background;
      }
    }
  }
}

}  // namespace

double length_px(const ImagePath& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  return length;
}

TruthMap rasterise(const Truth& truth, const Image<std::uint16_t>& object_masks,
                   const Image<float>& depth_m) {
  require_size(object_masks.size(), truth.size, "object masks");
  require_size(depth_m.size(), truth.size, "depth");
  TruthMap map{
      surface_labels(truth), Image<TruthRegion>(truth.size), std::vector<int>(truth.surfaces.size()), {}, {}};
  map.drawn = map.surfaces;
  classify(truth, object_masks, depth_m, map);
  for (int y = 0; y < truth.size.height; ++y) {
    for (int x = 0; x < truth.size.width; ++x) {
      if (map.surfaces(x, y) != 0) ++map.area_px[map.surfaces(x, y) - 1];
    }
  }
  for (const int area : map.area_px) map.surface_counts.push_back(area >= counted_surface_px);
  for (int y = 0; y < truth.size.height; ++y) {
    for (int x = 0; x < truth.size.width; ++x) {
      std::uint16_t& label = map.surfaces(x, y);
      if (label == 0 || map.surface_counts[label - 1]) continue;
      label = 0;
      map.regions(x, y) = TruthRegion::ignored;
    }
  }
  return map;
}

}  // namespace facet
