#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "truth/annotation.hpp"

namespace facet {
namespace {

using Json = nlohmann::json;

/// Reads one annotation; collects what is wrong instead of stopping.
class Reader {
 public:
  Reader(Size size, Annotation& out) : size_(size), out_(out) { out_.truth.size = size; }

  void read(const Json& root) {
    if (!root.is_object() || !root.contains("shapes") || !root["shapes"].is_array()) {
      return problem("no list 'shapes': this is not a LabelMe file");
    }
    check_image_size(root);
    const Json flags = root.value("flags", Json::object());
    shift_ = is_set(flags, "pixel_centres") ? 0 : -0.5;
    for (const Json& shape : root["shapes"]) {
      read_shape(shape);
      ++index_;
    }
  }

 private:
  void problem(const std::string& rule) { out_.problems.push_back({{}, rule}); }
  void shape_problem(const std::string& rule) { out_.problems.push_back({index_, rule}); }

  static bool is_set(const Json& flags, const char* name) {
    return flags.is_object() && flags.contains(name) && flags[name].is_boolean() && flags[name].get<bool>();
  }

  void check_image_size(const Json& root) {
    const auto number = [&](const char* key) {
      return root.contains(key) && root[key].is_number_integer() ? root[key].get<int>() : -1;
    };
    const Size found{number("imageWidth"), number("imageHeight")};
    if (found == size_) return;
    problem("imageWidth x imageHeight is " + std::to_string(found.width) + " x " +
            std::to_string(found.height) + ", the frame has " + std::to_string(size_.width) + " x " +
            std::to_string(size_.height));
  }

  void read_shape(const Json& shape) {
    if (!shape.is_object()) return shape_problem("not an object");
    const std::string label = text(shape, "label");
    const auto slash = label.find('/');
    const std::string kind = label.substr(0, slash);
    int number = -1;
    if (slash != std::string::npos) {
      const char* end = label.data() + label.size();
      const auto parsed = std::from_chars(label.data() + slash + 1, end, number);
      if (parsed.ec != std::errc{} || parsed.ptr != end) number = -1;
    }
    const bool known =
        kind == "surface" || kind == "edge" || kind == "ignore" || (kind == "support" && number == 0);
    if (!known || number < 0) {
      return shape_problem("unknown label '" + label +
                           "': expected surface/N, edge/N, support/0 or ignore/N");
    }
    const bool is_line = kind == "edge";
    const std::string type = text(shape, "shape_type");
    if (type != (is_line ? "linestrip" : "polygon")) {
      shape_problem(label + " must be a " + (is_line ? "linestrip" : "polygon") + ", not '" + type + "'");
    }
    const ImagePath path = read_points(shape, is_line ? 2 : 3);
    const auto group = read_group(shape, kind, label);
    const Json flags = shape.value("flags", Json::object());
    check_flags(flags);
    const int order = static_cast<int>(index_);
    if (kind == "surface")
      add_surface(number, group.value_or(0), flags, {path, order}, text(shape, "description"));
    if (kind == "edge") add_edge(number, group.value_or(0), flags, path, text(shape, "description"));
    if (kind == "support") out_.truth.support.push_back({path, order});
    if (kind == "ignore") out_.truth.ignore.push_back({path, order});
  }

  static std::string text(const Json& shape, const char* key) {
    return shape.contains(key) && shape[key].is_string() ? shape[key].get<std::string>() : std::string();
  }

  ImagePath read_points(const Json& shape, std::size_t least) {
    ImagePath path;
    if (!shape.contains("points") || !shape["points"].is_array()) {
      shape_problem("no list 'points'");
      return path;
    }
    for (const Json& point : shape["points"]) {
      if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number()) {
        shape_problem("a point must be two numbers");
        continue;
      }
      path.push_back({point[0].get<double>() + shift_, point[1].get<double>() + shift_});
      check_inside(path.back());
    }
    if (path.size() < least) shape_problem("fewer than " + std::to_string(least) + " points");
    return path;
  }

  /// The image covers [-0.5, width - 0.5] x [-0.5, height - 0.5].
  void check_inside(ImagePoint p) {
    const bool inside = p.x >= -0.5 && p.y >= -0.5 && p.x <= size_.width - 0.5 && p.y <= size_.height - 0.5;
    if (!inside)
      shape_problem("point (" + Json(p.x).dump() + ", " + Json(p.y).dump() + ") outside the image");
  }

  std::optional<int> read_group(const Json& shape, const std::string& kind, const std::string& label) {
    if (kind == "ignore") return {};
    if (!shape.contains("group_id") || !shape["group_id"].is_number_integer()) {
      shape_problem(label + " has no group_id");
      return {};
    }
    const int group = shape["group_id"].get<int>();
    if (kind == "support" ? group != 0 : group < 1) {
      shape_problem(label + " has the group_id " + std::to_string(group) + ", expected " +
                    (kind == "support" ? "0" : "an object id >= 1"));
    }
    return group;
  }

  void check_flags(const Json& flags) {
    static const std::set<std::string> known{"graspable", "curved", "depth", "convex", "concave"};
    if (!flags.is_object()) return shape_problem("'flags' must be an object");
    for (const auto& [name, value] : flags.items()) {
      if (!value.is_boolean()) shape_problem("flag '" + name + "' must be true or false");
      if (!known.contains(name)) shape_problem("unknown flag '" + name + "'");
    }
  }

  void add_surface(int number, int group, const Json& flags, TruthPolygon part,
                   const std::string& description) {
    const bool graspable = is_set(flags, "graspable"), curved = is_set(flags, "curved");
    for (TruthSurface& surface : out_.truth.surfaces) {
      if (surface.number != number || surface.object != group) continue;
      if (surface.graspable != graspable || surface.curved != curved) {
        shape_problem("parts of surface/" + std::to_string(number) + " have different flags");
      }
      surface.parts.push_back(std::move(part));
      return;
    }
    out_.truth.surfaces.push_back({number, group, graspable, curved, {std::move(part)}, description});
  }

  void add_edge(int number, int group, const Json& flags, ImagePath line, const std::string& description) {
    const bool depth = is_set(flags, "depth"), convex = is_set(flags, "convex"),
               concave = is_set(flags, "concave");
    const int kinds = depth + convex + concave;
    if (kinds != 1) {
      shape_problem("an edge must have exactly one of depth, convex, concave; " + std::to_string(kinds) +
                    " are set");
    }
    const bool graspable = is_set(flags, "graspable");
    if (concave && graspable) shape_problem("a concave edge cannot be graspable");
    if (!edge_numbers_.insert(number).second) shape_problem("repeated label edge/" + std::to_string(number));
    const EdgeKind kind = depth ? EdgeKind::depth : convex ? EdgeKind::convex : EdgeKind::concave;
    out_.truth.edges.push_back({number, group, kind, graspable, std::move(line), description});
  }

  Size size_;
  Annotation& out_;
  double shift_ = 0;
  std::size_t index_ = 0;
  std::set<int> edge_numbers_;
};

}  // namespace

Annotation parse_annotation(std::string_view text, Size size) {
  Annotation annotation;
  const Json root = Json::parse(text, nullptr, false);
  if (root.is_discarded()) {
    annotation.truth.size = size;
    annotation.problems.push_back({{}, "not JSON"});
    return annotation;
  }
  Reader(size, annotation).read(root);
  return annotation;
}

Truth read_annotation(const std::filesystem::path& path, Size size) {
  const std::vector<std::uint8_t> bytes = read_file_bytes(path);
  Annotation annotation = parse_annotation({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, size);
  if (annotation.problems.empty()) return std::move(annotation.truth);
  std::string message = printable(path) + ": " + std::to_string(annotation.problems.size()) + " broken rules";
  for (const AnnotationProblem& problem : annotation.problems) {
    message += "\n  " + (problem.shape ? "shape " + std::to_string(*problem.shape) + ": " : std::string()) +
               problem.rule;
  }
  throw Error(ErrorKind::data, message);
}

}  // namespace facet
