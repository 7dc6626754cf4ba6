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

RigidMotion upside_down(double height_m) {
  return translation({0, 0, height_m}) * rotation({1, 0, 0}, M_PI);
}

RigidMotion lying(double radius_m, double height_m) {
  return translation({0, height_m / 2, radius_m}) * rotation({1, 0, 0}, M_PI / 2);
}

}  // namespace facet
