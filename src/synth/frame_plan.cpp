#include "synth/frame_plan.hpp"

#include <cmath>

#include "core/error.hpp"
#include "synth/families.hpp"
#include "synth/special_scenes.hpp"
#include "synth/table2.hpp"

namespace facet {
namespace {

constexpr double degree = M_PI / 180;
constexpr double special_distance_m = 0.9, nearest_camera_m = 0.1;

std::string numbered(const std::string& stem, int number) {
  const std::string digits = std::to_string(number);
  return stem + "_" + std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

/// "0.5", "12", "90": a level as it stands in file names.
std::string level_text(double level) {
  std::string text = std::to_string(level);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

SceneRecipe recipe_at(const SetSpec& spec, double level) {
  SceneRecipe recipe = scene_family(spec.scenes);
  if (spec.vary == Vary::objects) recipe.fewest = recipe.most = static_cast<int>(level);
  if (spec.vary == Vary::object_scale) recipe.object_scale *= level;
  if (spec.vary == Vary::occlusion) {
    recipe.least_hidden = level > 0 ? level - 0.05 : 0;
    recipe.most_hidden = level > 0 ? level + 0.05 : 0.02;
  }
  if (spec.distance_m > 0) recipe.nearest_m = recipe.farthest_m = spec.distance_m;
  return recipe;
}

Layout layout_of(const SetSpec& spec, const PlannedFrame& planned) {
  const auto index = static_cast<std::uint64_t>(planned.scene);
  const double distance = spec.distance_m > 0 ? spec.distance_m : special_distance_m;
  if (spec.scenes == "table2") {
    const auto& rows = table2_rows();
    const std::size_t row = index % rows.size();
    return table2_layout(rows[row], spec.seed + index / rows.size(), spec.sensor.camera(),
                         spec.sensor.size());
  }
  if (spec.scenes == "crease") return crease_layout(planned.level, distance, spec.seed, index);
  if (spec.scenes == "gap") return gap_layout(planned.level, distance, spec.seed, index);
  if (spec.scenes == "strips") return strip_layout(distance, spec.seed, index);
  return family_layout(recipe_at(spec, planned.level), spec.seed, index, spec.sensor.camera(),
                       spec.sensor.size());
}

/// Camera at the given elevation and distance on its present side of the scene.
RigidMotion seen_from(const RigidMotion& T_world_camera, double elevation_rad, double distance_m) {
  const Vec3d away = T_world_camera.origin - scene_middle;
  const double flat = std::hypot(away.x, away.y);
  const Vec3d direction{std::cos(elevation_rad) * away.x / flat, std::cos(elevation_rad) * away.y / flat,
                        std::sin(elevation_rad)};
  return look_at(scene_middle + distance_m * direction, scene_middle);
}

void move_camera(const SetSpec& spec, const PlannedFrame& planned, View& view) {
  RigidMotion& camera = view.T_world_camera;
  const Vec3d away = camera.origin - scene_middle;
  double elevation = std::asin(away.z / norm(away)), distance = norm(away);
  if (spec.vary == Vary::distance_m) distance = planned.level;
  if (spec.vary == Vary::tilt_deg) elevation = planned.level * degree;
  const double progress = spec.frames > 1 ? static_cast<double>(planned.frame) / (spec.frames - 1) : 0;
  distance += progress * spec.path_distance_m;
  if (distance < nearest_camera_m)
    throw Error(ErrorKind::config, "path.distance_m: the camera would come nearer than 0.1 m to the scene");
  if (elevation != std::asin(away.z / norm(away)) || distance != norm(away)) {
    camera = seen_from(camera, elevation, distance);
  }
  if (spec.path_yaw_deg != 0) camera = rotation({0, 0, 1}, progress * spec.path_yaw_deg * degree) * camera;
  if (spec.vary == Vary::roll_deg) camera = camera * rotation({0, 0, 1}, planned.level * degree);
  if (spec.vary != Vary::yaw_deg) return;
  for (SceneObject& object : view.scene.objects) {
    object.pose = rotation({0, 0, 1}, planned.level * degree) * object.pose;
  }
}

SensorSettings sensor_at(const SetSpec& spec, double level) {
  SensorSettings sensor = spec.sensor;
  const auto value = static_cast<float>(level);
  if (spec.vary == Vary::noise)
    sensor.kinect_v1.scale = sensor.azure_kinect.scale = sensor.stereo.scale = value;
  if (spec.vary == Vary::dropout) sensor.kinect_v1.dropout_share = value;
  if (spec.vary == Vary::shadow) sensor.kinect_v1.shadow = level > 0;
  if (spec.vary == Vary::reflectivity) sensor.azure_kinect.reflectivity = value;
  return sensor;
}

Image<float> measured(const SensorSettings& sensor, const Rendering& exact, const Camera& camera,
                      std::uint64_t seed) {
  if (sensor.exact) return exact.depth_m;
  switch (sensor.model) {
    case Sensor::azure_kinect:
      return measure(sensor.azure_kinect, exact, camera, seed);
    case Sensor::stereo:
      return measure(sensor.stereo, exact, camera, seed);
    default:
      return measure(sensor.kinect_v1, exact, camera, seed);
  }
}

}  // namespace

std::vector<PlannedFrame> plan_frames(const SetSpec& spec) {
  check_set(spec);
  std::vector<PlannedFrame> frames;
  const std::vector<double> levels = spec.levels.empty() ? std::vector<double>{0} : spec.levels;
  for (const double level : levels) {
    const std::string stem = spec.vary == Vary::nothing
                                 ? spec.scenes
                                 : std::string(vary_infos()[static_cast<std::size_t>(spec.vary) - 1].name) +
                                       "_" + level_text(level);
    const bool in_range = spec.vary != Vary::distance_m ||
                          (level >= spec.sensor.nearest_m() && level <= spec.sensor.farthest_m());
    for (int scene = 0; scene < spec.count; ++scene) {
      for (int frame = 0; frame < spec.frames; ++frame) {
        PlannedFrame planned{.id = numbered(stem, scene), .scene = scene, .frame = frame, .level = level};
        if (spec.frames > 1) {
          planned.sequence = planned.id;
          planned.id = numbered("frame", frame);
        }
        if (!in_range) planned.not_available = "n/a (range)";
        frames.push_back(std::move(planned));
      }
    }
  }
  return frames;
}

PlannedPose planned_pose(const SetSpec& spec, const PlannedFrame& planned) {
  Layout layout = layout_of(spec, planned);
  move_camera(spec, planned, layout.view);
  return {planned.frame / 30.0, layout.view.T_world_camera};
}

PlannedPicture make_planned(const SetSpec& spec, const PlannedFrame& planned) try {
  Layout layout = layout_of(spec, planned);
  PlannedPicture picture{.view = std::move(layout.view), .camera = spec.sensor.camera()};
  move_camera(spec, planned, picture.view);
  picture.objects_requested = layout.requested;
  picture.timestamp_s = planned.frame / 30.0;
  const PosedScene posed(picture.view.scene, picture.view.T_world_camera);
  picture.exact = render(posed, picture.camera, spec.sensor.size());
  const auto stream = static_cast<std::uint64_t>(planned.scene);
  const std::uint64_t noise_seed = random_bits(spec.seed, stream, static_cast<std::uint64_t>(planned.frame));
  picture.depth_m = measured(sensor_at(spec, planned.level), picture.exact, picture.camera, noise_seed);
  return picture;
} catch (const Error& error) {
  const std::string place = (planned.sequence.empty() ? "" : planned.sequence + "/") + planned.id;
  throw Error(error.kind(), "set '" + spec.name + "': " + place + ": " + error.what());
}

}  // namespace facet
