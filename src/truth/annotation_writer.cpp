#include <nlohmann/json.hpp>

#include "truth/annotation.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;

Json shape_of(const std::string& label, const ImagePath& path, const Json& group, const char* type,
              Json flags, const std::string& description) {
  Json points = Json::array();
  for (const ImagePoint p : path) points.push_back({p.x, p.y});
  return {{"label", label},     {"points", points},          {"group_id", group},
          {"shape_type", type}, {"flags", std::move(flags)}, {"description", description}};
}

Json shape_of(const TruthEdge& edge) {
  return shape_of("edge/" + std::to_string(edge.number), edge.line, edge.object, "linestrip",
                  {{"depth", edge.kind == EdgeKind::depth},
                   {"convex", edge.kind == EdgeKind::convex},
                   {"concave", edge.kind == EdgeKind::concave},
                   {"graspable", edge.graspable}},
                  edge.description);
}

}  // namespace

std::string annotation_text(const Truth& truth, const std::string& image_name) {
  Json shapes = Json::array();
  for (const TruthSurface& surface : truth.surfaces) {
    for (const TruthPolygon& part : surface.parts) {
      shapes.push_back(shape_of("surface/" + std::to_string(surface.number), part.path, surface.object,
                                "polygon", {{"graspable", surface.graspable}, {"curved", surface.curved}},
                                surface.description));
    }
  }
  for (const TruthEdge& edge : truth.edges) shapes.push_back(shape_of(edge));
  for (const TruthPolygon& part : truth.support) {
    shapes.push_back(shape_of("support/0", part.path, 0, "polygon", Json::object(), "table top"));
  }
  int number = 0;
  for (const TruthPolygon& part : truth.ignore) {
    shapes.push_back(
        shape_of("ignore/" + std::to_string(++number), part.path, nullptr, "polygon", Json::object(), ""));
  }
  const Json root{{"version", "5.4.1"},
                  {"flags", {{"pixel_centres", true}}},
                  {"shapes", shapes},
                  {"imagePath", image_name},
                  {"imageData", nullptr},
                  {"imageHeight", truth.size.height},
                  {"imageWidth", truth.size.width}};
  return root.dump(1) + "\n";
}

}  // namespace facet
