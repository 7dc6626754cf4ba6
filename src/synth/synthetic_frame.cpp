#include "synth/synthetic_frame.hpp"

#include "core/error.hpp"
#include "core/random.hpp"

namespace facet {
namespace {

std::vector<View> views_of(const SyntheticSpec& spec) {
  if (spec.scenes == "quickstart") return quickstart_views(spec.seed);
  if (spec.scenes == "plane_and_box") return {plane_and_box_view()};
  throw Error(ErrorKind::config, "scenes: no built-in set is called '" + spec.scenes +
                                     "'; expected quickstart or plane_and_box");
}

}  // namespace

std::vector<std::string> synthetic_scene_sets() {
  return {"quickstart", "plane_and_box"};
}

std::vector<std::string> frame_ids(const SyntheticSpec& spec) {
  std::vector<std::string> ids;
  for (const View& view : views_of(spec)) ids.push_back(view.name);
  return ids;
}

SyntheticFrame make_frame(const SyntheticSpec& spec, std::size_t index) {
  std::vector<View> views = views_of(spec);
  if (index >= views.size()) {
    throw Error(ErrorKind::config, "scenes: '" + spec.scenes + "' has no frame " + std::to_string(index));
  }
  SyntheticFrame frame{.view = std::move(views[index]), .camera = kinect_v1_camera()};
  frame.id = frame.view.name;
  const PosedScene posed(frame.view.scene, frame.view.T_world_camera);
  frame.exact = render(posed, frame.camera, kinect_v1_size());
  frame.depth_m = spec.noise_free
                      ? frame.exact.depth_m
                      : measure(spec.sensor, frame.exact, frame.camera, random_bits(spec.seed, 7, index));
  return frame;
}

}  // namespace facet
