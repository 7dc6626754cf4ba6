#include "synth/set_spec.hpp"

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

const std::vector<std::string>& vary_names() {
  static const std::vector<std::string> names{
      "objects",   "noise",   "distance_m", "object_scale", "roll_deg",   "tilt_deg", "yaw_deg",
      "occlusion", "dropout", "shadow",     "reflectivity", "crease_deg", "gap_mm"};
  return names;
}

void check_set(const SetSpec& spec) {
  const bool special =
      spec.scenes == "table2" || spec.scenes == "crease" || spec.scenes == "gap" || spec.scenes == "strips";
  if (!special) scene_family(spec.scenes);
  require(spec.count >= 1, spec, "count: at least 1");
  require(spec.frames >= 1, spec, "frames: at least 1");
  require((spec.vary == Vary::nothing) == spec.levels.empty(), spec,
          "vary: needs levels, and levels need it");
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
