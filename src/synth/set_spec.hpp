#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/sensor.hpp"
#include "synth/azure_kinect.hpp"
#include "synth/kinect_v1.hpp"
#include "synth/stereo_camera.hpp"

namespace facet {

/// A simulated sensor with its settings; those of the other models are unused.
struct SensorSettings {
  Sensor model = Sensor::kinect_v1;
  bool exact = false;  ///< the exact depth instead of a measurement
  KinectV1 kinect_v1{};
  AzureKinect azure_kinect{};
  StereoCamera stereo{};

  Camera camera() const;
  Size size() const;
  double nearest_m() const;
  double farthest_m() const;
};

/// What a set of scenes varies, one level after the other, everything else kept the same.
enum class Vary {
  nothing,
  objects,       ///< number of objects
  noise,         ///< factor on the sensor's random errors
  distance_m,    ///< of the camera from the middle of the scene
  object_scale,  ///< factor on the size of the objects
  roll_deg,      ///< of the camera about its optical axis
  tilt_deg,      ///< elevation of the camera above the table
  yaw_deg,       ///< of the objects about the vertical
  occlusion,     ///< share of the most hidden object that others hide
  dropout,       ///< share of readings lost at random (Kinect v1)
  shadow,        ///< 0: without the projector's shadow, 1: with it (Kinect v1)
  reflectivity,  ///< of all surfaces (Azure Kinect)
  crease_deg,    ///< angle at the ridges of the scenes `crease`
  gap_mm,        ///< width of the gaps of the scenes `gap`
};

/// A set of frames: `count` scenes for every level, `frames` pictures of each.
struct SetSpec {
  std::string name;
  std::string scenes = "mixed";  ///< a family, or table2, crease, gap, strips
  int count = 1;
  std::uint64_t seed = 1;
  SensorSettings sensor{};
  Vary vary = Vary::nothing;
  std::vector<double> levels{};
  double distance_m = 0;       ///< of the camera; 0: as the family has it
  int frames = 1;              ///< more than one: every scene is a sequence at 30 Hz
  double path_yaw_deg = 0;     ///< the camera's way round the scene over a sequence
  double path_distance_m = 0;  ///< and away from it
};

/// Something that a set can vary.
struct VaryInfo {
  const char* name;  ///< in specs and in the ids of frames
  double lowest, highest;
  bool whole = false;  ///< levels are whole numbers
};
/// In the order of Vary after `nothing`.
const std::vector<VaryInfo>& vary_infos();
/// Error{config} naming set, key and rule where the spec is impossible.
void check_set(const SetSpec& spec);

}  // namespace facet
