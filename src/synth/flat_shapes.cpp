#include "core/error.hpp"
#include "synth/shape_parts.hpp"
#include "synth/shapes.hpp"

namespace facet {

SceneObject make_box(Vec3d size_m) {
  require_positive({size_m.x, size_m.y, size_m.z}, "box");
  const double x = size_m.x / 2, y = size_m.y / 2, z = size_m.z;
  return make_polyhedron("box", {{"top", {{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}}},
                                 {"bottom", {{-x, y, 0}, {x, y, 0}, {x, -y, 0}, {-x, -y, 0}}},
                                 {"front", {{-x, -y, 0}, {x, -y, 0}, {x, -y, z}, {-x, -y, z}}},
                                 {"back", {{x, y, 0}, {-x, y, 0}, {-x, y, z}, {x, y, z}}},
                                 {"left", {{-x, y, 0}, {-x, -y, 0}, {-x, -y, z}, {-x, y, z}}},
                                 {"right", {{x, -y, 0}, {x, y, 0}, {x, y, z}, {x, -y, z}}}});
}

SceneObject make_wedge(Vec3d size_m) {
  require_positive({size_m.x, size_m.y, size_m.z}, "wedge");
  const double x = size_m.x / 2, y = size_m.y / 2, z = size_m.z;
  return make_polyhedron("wedge", {{"slope", {{-x, -y, 0}, {x, -y, 0}, {x, y, z}, {-x, y, z}}},
                                   {"bottom", {{-x, y, 0}, {x, y, 0}, {x, -y, 0}, {-x, -y, 0}}},
                                   {"back", {{x, y, 0}, {-x, y, 0}, {-x, y, z}, {x, y, z}}},
                                   {"left", {{-x, y, 0}, {-x, -y, 0}, {-x, y, z}}},
                                   {"right", {{x, -y, 0}, {x, y, 0}, {x, y, z}}}});
}

SceneObject make_ridge(Vec3d size_m, double crease_rad) {
  require_positive({size_m.x, size_m.y, size_m.z}, "ridge");
  if (!(crease_rad > 0 && crease_rad <= M_PI / 2 + 1e-9)) {
    throw Error(ErrorKind::config, "ridge: the crease must be between 0 and 90 degrees");
  }
  const double x = size_m.x / 2, y = size_m.y / 2, e = size_m.z, t = e + x * std::tan(crease_rad / 2);
  return make_polyhedron("ridge", {{"left slope", {{-x, y, e}, {-x, -y, e}, {0, -y, t}, {0, y, t}}},
                                   {"right slope", {{0, y, t}, {0, -y, t}, {x, -y, e}, {x, y, e}}},
                                   {"bottom", {{-x, y, 0}, {x, y, 0}, {x, -y, 0}, {-x, -y, 0}}},
                                   {"left", {{-x, y, 0}, {-x, -y, 0}, {-x, -y, e}, {-x, y, e}}},
                                   {"right", {{x, -y, 0}, {x, y, 0}, {x, y, e}, {x, -y, e}}},
                                   {"front", {{-x, -y, 0}, {x, -y, 0}, {x, -y, e}, {0, -y, t}, {-x, -y, e}}},
                                   {"back", {{x, y, 0}, {-x, y, 0}, {-x, y, e}, {0, y, t}, {x, y, e}}}});
}

RigidMotion upside_down(double height_m) {
  return translation({0, 0, height_m}) * rotation({1, 0, 0}, M_PI);
}

RigidMotion lying(double radius_m, double height_m) {
  return translation({0, height_m / 2, radius_m}) * rotation({1, 0, 0}, M_PI / 2);
}

}  // namespace facet
