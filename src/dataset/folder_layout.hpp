#pragma once

#include <filesystem>
#include <optional>

#include "core/camera.hpp"
#include "core/sensor.hpp"
#include "dataset/frame_list.hpp"
#include "dataset/frame_loader.hpp"
#include "dataset/reader_options.hpp"

namespace facet {

/// What is where in a folder of images, and how its numbers are to be understood.
struct FolderLayout {
  FramePattern depth;
  std::optional<FramePattern> color = std::nullopt;
  DepthFormat format{};
  Camera camera{};
  bool registered = false;                       ///< colour was taken through, or mapped to, the depth camera
  bool sequence = false;                         ///< frames are consecutive in time
  std::optional<double> rate_hz = std::nullopt;  ///< of a sequence whose frames are numbered
  Sensor sensor = Sensor::automatic;
};

/// The options in `root`/dataset.yaml, none where there is no such file. Throws Error{config} naming file,
/// line and column where it is not a flat map of known names, scalars and lists.
ReaderOptions read_dataset_yaml(const std::filesystem::path& root);

/// Throws Error{config} where an option is wrong or a required one (depth, depth_unit_m, intrinsics) is
/// absent.
FolderLayout folder_layout(const ReaderOptions& options, const std::filesystem::path& root);

}  // namespace facet
