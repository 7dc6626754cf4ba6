#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/registry.hpp"

namespace facet {

/// Whether `a` comes before `b` when runs of digits compare as numbers: learn2 before learn10.
bool natural_less(std::string_view a, std::string_view b);

/// How the files of one kind are called: "{id}.depth.png", "depth/{id}.png". `{id}` stands once, in the last
/// part.
class FramePattern {
 public:
  /// Throws Error{config} where the pattern has no place for the id, or two.
  explicit FramePattern(const std::string& pattern);
  std::filesystem::path path(const std::filesystem::path& root, std::string_view id) const;
  /// The ids of the files below `root` that fit the pattern, in natural order. Throws Error{data} where the
  /// folder is missing.
  std::vector<std::string> list(const std::filesystem::path& root) const;

 private:
  std::filesystem::path folder_;
  std::string before_, after_;
};

/// The frames that the spec selects among `available`, or all of them. Throws Error{data} naming every
/// selected frame that does not exist, or where there is none at all.
std::vector<std::string> select_frames(const DatasetSpec& spec, const std::vector<std::string>& available);

/// The object masks that came with a frame; empty where there are none.
Image<std::uint16_t> masks_of(const Frame& frame);

/// A data set whose frames were listed when it was opened.
class ListedDataset : public Dataset {
 public:
  /// Throws Error{data} where the spec names a folder of annotations that is not there.
  ListedDataset(const DatasetSpec& spec, Sensor sensor, std::vector<std::string> ids);
  const std::string& name() const override { return name_; }
  Sensor sensor() const override { return sensor_; }
  std::size_t size() const override { return ids_.size(); }
  std::string frame_id(std::size_t index) const override { return ids_.at(index); }
  /// From the folder that the spec names, else from `truth` below the root, else, of a sequence, from beside
  /// the depth image, else the masks that came with the frame.
  std::optional<FrameAnnotation> annotation(std::size_t index, const Frame& frame) const override;

 private:
  std::string name_;
  Sensor sensor_;
  std::vector<std::string> ids_;
  std::vector<std::filesystem::path> annotation_folders_;
};

}  // namespace facet
