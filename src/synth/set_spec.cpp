#include "synth/set_spec.hpp"

#include <set>

#include "core/error.hpp"
#include "synth/families.hpp"

namespace facet {
namespace {

void require(bool good, const SetSpec& spec, const std::string& rule) {
  if (!good) throw Error(ErrorKind::config, "set '" + spec.name + "': " + rule);
}

}  // namespace

Camera SensorSettings::camera() const {
  switch (model) {
    case Sensor::azure_kinect:
      return azure_kinect_camera();
    case Sensor::stereo:
      return stereo_camera();
    default:
      return kinect_v1_camera();
  }
}

Size SensorSettings::size() const {
  switch (model) {
    case Sensor::azure_kinect:
      return azure_kinect_size();
    case Sensor::stereo:
      return stereo_camera_size();
    default:
      return kinect_v1_size();
  }
}

double SensorSettings::nearest_m() const {
  switch (model) {
    case Sensor::azure_kinect:
      return azure_kinect.nearest_m;
    case Sensor::stereo:
      return stereo.nearest_m;
    default:
      return kinect_v1.nearest_m;
  }
}

double SensorSettings::farthest_m() const {
  switch (model) {
    case Sensor::azure_kinect:
      return azure_kinect.farthest_m;
    case Sensor::stereo:
      return stereo.farthest_m;
    default:
      return kinect_v1.farthest_m;
  }
}

const std::vector<VaryInfo>& vary_infos() {
  static const std::vector<VaryInfo> infos{
      {"objects", 1, 1000, true}, {"noise", 0, 100},         {"distance_m", 0.1, 10},
      {"object_scale", 0.05, 20}, {"roll_deg", -360, 360},   {"tilt_deg", 0, 90},
      {"yaw_deg", -360, 360},     {"occlusion", 0, 0.95},    {"dropout", 0, 1},
      {"shadow", 0, 1, true},     {"reflectivity", 0.05, 1}, {"crease_deg", 1, 90},
      {"gap_mm", 0, 100}};
  return infos;
}

void check_set(const SetSpec& spec) {
  const bool special =
      spec.scenes == "table2" || spec.scenes == "crease" || spec.scenes == "gap" || spec.scenes == "strips";
  if (!special) scene_family(spec.scenes);
  require(spec.count >= 1, spec, "count: at least 1");
  require(spec.frames >= 1, spec, "frames: at least 1");
  require((spec.vary == Vary::nothing) == spec.levels.empty(), spec,
          "vary: needs levels, and levels need it");
  std::set<std::string> levels;
  for (const double level : spec.levels)
    require(levels.insert(std::to_string(level)).second, spec, "vary: a level is given twice");
  require((spec.scenes == "crease") == (spec.vary == Vary::crease_deg), spec,
          "scenes crease and vary crease_deg belong together");
  require((spec.scenes == "gap") == (spec.vary == Vary::gap_mm), spec,
          "scenes gap and vary gap_mm belong together");
  const bool of_kinect = spec.vary == Vary::dropout || spec.vary == Vary::shadow;
  require(!of_kinect || spec.sensor.model == Sensor::kinect_v1, spec,
          "vary: dropout and shadow are those of kinect_v1");
  require(spec.vary != Vary::reflectivity || spec.sensor.model == Sensor::azure_kinect, spec,
          "vary: reflectivity is that of azure_kinect");
  const bool of_recipe =
      spec.vary == Vary::objects || spec.vary == Vary::object_scale || spec.vary == Vary::occlusion;
  require(!special || !of_recipe, spec,
          "vary: scenes " + spec.scenes + " have a fixed number and size of objects");
}

}  // namespace facet
