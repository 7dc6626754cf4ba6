#pragma once

#include <optional>
#include <string>

#include "dataset/dataset.hpp"
#include "score/frame_truth.hpp"

namespace facet {

/// The truth of a frame that was loaded, nothing where it is not annotated. `source` becomes where it is
/// from; the files read for it are added to those of the frame. Throws Error{data} as Dataset::annotation()
/// does.
std::optional<FrameTruth> read_truth(const Dataset& data, std::size_t index, Frame& frame,
                                     std::string& source);

}  // namespace facet
