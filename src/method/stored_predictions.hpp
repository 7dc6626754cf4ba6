#pragma once

#include <memory>
#include <string>
#include <vector>

#include "method/registry.hpp"

namespace facet {

/// Reads the predictions that any program has written into the folder `spec.folder`: FRAME.labels.png and, if
/// they are there, FRAME.edges.png and FRAME.surfaces.json; or COCO instances in place of them, with
/// `instances`; poses beside either, with `poses` (see bop_poses.hpp). A frame without a label image is one
/// that the method has failed on. Throws Error{config} without a folder, Error{data} where it or a file that
/// is named is missing or broken.
std::unique_ptr<Method> make_stored_predictions(const MethodSpec& spec, const MethodContext& context);

/// Frames that the predictions name and that are none of these, in alphabetical order.
std::vector<std::string> predictions_without_frame(const MethodSpec& spec,
                                                   const std::vector<std::string>& frame_ids);

}  // namespace facet
