#include "experiment/dataset_truth.hpp"

#include "file/file_bytes.hpp"

namespace facet {

std::optional<FrameTruth> read_truth(const Dataset& data, std::size_t index, Frame& frame,
                                     std::string& source) {
  std::optional<FrameAnnotation> annotation = data.annotation(index, frame);
  if (!annotation) return {};
  source = escaped_utf8(annotation->source);
  frame.files.insert(frame.files.end(), annotation->files.begin(), annotation->files.end());
  if (!annotation->truth) return frame_truth(annotation->object_masks, frame.depth_m);
  return frame_truth(*annotation->truth, annotation->object_masks, frame.depth_m,
                     std::move(annotation->poses));
}

}  // namespace facet
