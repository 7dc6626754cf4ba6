#include "bench_scene.hpp"

#include <map>
#include <utility>

#include "synth/synthetic_frame.hpp"

namespace facet {

const BenchScene& bench_scene(Size size) {
  static std::map<std::pair<int, int>, BenchScene> scenes;
  const auto [place, is_new] = scenes.try_emplace({size.width, size.height});
  BenchScene& scene = place->second;
  if (is_new) {
    const float focal_px = 525.0f * static_cast<float>(size.width) / 640;
    scene.camera = {focal_px, focal_px, static_cast<float>(size.width - 1) / 2,
                    static_cast<float>(size.height - 1) / 2};
    const View view = quickstart_views(1)[4];
    const PosedScene posed(view.scene, view.T_world_camera);
    scene.depth_m = measure({}, render(posed, scene.camera, size), scene.camera, 1);
  }
  return scene;
}

}  // namespace facet
