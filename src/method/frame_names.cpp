#include "method/frame_names.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace facet {

std::string frame_named(const std::string& pattern, int scene_id, int im_id) {
  try {
    return fmt::format(fmt::runtime(pattern), fmt::arg("scene_id", scene_id), fmt::arg("im_id", im_id));
  } catch (const fmt::format_error& e) {
    throw Error(ErrorKind::config, "frame_id: \"" + pattern + "\": " + e.what());
  }
}

}  // namespace facet
