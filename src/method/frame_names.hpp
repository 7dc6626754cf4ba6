#pragma once

#include <string>

namespace facet {

/// The frame that a file of numbers means: `pattern` with {scene_id} and {im_id} in it, in the format of fmt,
/// "{scene_id:02}/{im_id:06}". Throws Error{config} where the pattern is none.
std::string frame_named(const std::string& pattern, int scene_id, int im_id);

}  // namespace facet
