#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dataset/registry.hpp"

namespace facet {

/// Frames of which the data set is known to have a certain number.
struct FrameGroup {
  std::string name{};
  std::size_t expected = 0;
  std::vector<std::string> absent{};

  std::size_t found() const { return expected - absent.size(); }
};

/// What `dataset info` and `dataset verify` print.
struct DatasetReport {
  struct ImageSize {
    Size size;
    std::size_t frames = 0;
  };
  struct Problem {
    std::string subject;  ///< a frame or a file
    std::string message;  ///< file and rule, every broken file of the frame
  };

  std::string description;
  Sensor sensor = Sensor::automatic;
  bool is_sequence = false;
  std::size_t frames = 0, readable = 0, with_color = 0, with_masks = 0;  ///< numbers of frames
  std::vector<ImageSize> image_sizes;
  float nearest_m = 0, farthest_m = 0;  ///< over all measured depths; both 0 where there are none
  double missing_share = 0;             ///< of the pixels of the readable frames, 0..1
  std::vector<FrameGroup> groups;
  std::size_t checksums_compared = 0;
  std::vector<Problem> problems;
  std::vector<std::string> notes;

  /// Every file can be read, known checksums agree, and no expected frame is absent.
  bool is_whole() const;
};

/// Reads every frame and notes all problems, instead of stopping at the first. Throws as open_dataset() does
/// where there is nothing to read at all.
DatasetReport verify_dataset(const DatasetSpec& spec);

}  // namespace facet
