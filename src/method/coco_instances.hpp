#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "prediction/prediction.hpp"

namespace facet {

/// Instances in COCO's JSON: a list of results, {image_id, segmentation, score}, or a whole data set with
/// `images` and `annotations`. A segmentation is run-length encoded, {size: [height, width], counts}, as the
/// text that pycocotools writes or as a list of numbers, or a list of polygons. An image is a frame by its
/// file_name without the ending, or, where there are no `images`, by `frame_id` with image_id as {im_id}.
///
/// The text form is decoded here: Debian ships no library for it, and it is 20 lines.
class CocoInstances {
 public:
  /// Throws Error{data} naming file and rule.
  CocoInstances(std::filesystem::path file, const std::string& frame_id);
  ~CocoInstances();
  CocoInstances(CocoInstances&&) noexcept;

  /// Labels 1, 2 ... in the order of the file; where instances overlap, the pixel is of that with the higher
  /// score, of equal ones of the earlier. A frame that the file does not name has none. Throws Error{data}
  /// for a segmentation of another size or one that cannot be decoded.
  Image<std::uint16_t> labels_of(const std::string& frame, Size size) const;

  std::vector<std::string> frames() const;

 private:
  struct Instance;
  std::filesystem::path file_;
  std::map<std::string, std::vector<Instance>> instances_;
};

/// Run lengths out of COCO's text: numbers of 5 bits per character from '0' on, from the third on relative to
/// the last but one. Throws Error{data} where the text breaks off.
std::vector<long> decode_coco_runs(const std::string& text);

}  // namespace facet
