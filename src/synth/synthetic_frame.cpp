#include "synth/synthetic_frame.hpp"

#include "core/error.hpp"
#include "core/random.hpp"
#include "synth/families.hpp"
#include "synth/table2.hpp"

namespace facet {
namespace {

constexpr std::size_t scenes_per_family = 10;

std::size_t count_of(const std::string& scenes) {
  if (scenes == "quickstart") return quickstart_views(1).size();
  if (scenes == "plane_and_box") return 1;
  if (scenes == "table2") return table2_rows().size();
  for (const SceneRecipe& family : scene_families()) {
    if (family.name == scenes) return scenes_per_family;
  }
  std::string names;
  for (const std::string& name : synthetic_scene_sets()) names += (names.empty() ? "" : ", ") + name;
  throw Error(ErrorKind::config,
              "scenes: no built-in set is called '" + scenes + "'; expected one of " + names);
}

std::string id_of(const std::string& scenes, std::size_t index) {
  if (scenes == "quickstart") return quickstart_views(1)[index].name;
  if (scenes == "plane_and_box") return scenes;
  if (scenes == "table2") return table2_rows()[index].name;
  return scenes + "_" + std::to_string(index);
}

View view_of(const SyntheticSpec& spec, std::size_t index) {
  const Camera camera = kinect_v1_camera();
  const Size size = kinect_v1_size();
  if (spec.scenes == "quickstart") return quickstart_views(spec.seed)[index];
  if (spec.scenes == "plane_and_box") return plane_and_box_view();
  if (spec.scenes == "table2") return table2_layout(table2_rows()[index], spec.seed, camera, size).view;
  return family_layout(scene_family(spec.scenes), spec.seed, index, camera, size).view;
}

}  // namespace

std::vector<std::string> synthetic_scene_sets() {
  std::vector<std::string> names{"quickstart", "plane_and_box"};
  for (const SceneRecipe& family : scene_families()) names.push_back(family.name);
  names.push_back("table2");
  return names;
}

std::vector<std::string> frame_ids(const SyntheticSpec& spec) {
  std::vector<std::string> ids;
  for (std::size_t k = 0; k < count_of(spec.scenes); ++k) ids.push_back(id_of(spec.scenes, k));
  return ids;
}

SyntheticFrame make_frame(const SyntheticSpec& spec, std::size_t index) {
  if (index >= count_of(spec.scenes)) {
    throw Error(ErrorKind::config, "scenes: '" + spec.scenes + "' has no frame " + std::to_string(index));
  }
  SyntheticFrame frame{
      .id = id_of(spec.scenes, index), .view = view_of(spec, index), .camera = kinect_v1_camera()};
  const PosedScene posed(frame.view.scene, frame.view.T_world_camera);
  frame.exact = render(posed, frame.camera, kinect_v1_size());
  frame.depth_m = spec.noise_free
                      ? frame.exact.depth_m
                      : measure(spec.sensor, frame.exact, frame.camera, random_bits(spec.seed, 7, index));
  return frame;
}

}  // namespace facet
