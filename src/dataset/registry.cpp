#include "dataset/registry.hpp"

#include <array>

#include "core/error.hpp"
#include "dataset/azure_mkv.hpp"
#include "dataset/benchmark.hpp"
#include "dataset/benchmark_place.hpp"
#include "dataset/folder.hpp"
#include "dataset/osd.hpp"
#include "dataset/osd_inventory.hpp"
#include "dataset/seven_scenes.hpp"
#include "dataset/synthetic.hpp"
#include "dataset/tum.hpp"

namespace facet {

std::span<const ReaderInfo> readers() {
  static const std::array<ReaderInfo, 7> table{{
      {"osd", "Object Segmentation Database 0.2 (TU Wien): Kinect v1, table-top clutter", osd_options(), true,
       open_osd, inspect_osd},
      {"folder", "depth images (and colour) in one folder, described by dataset.yaml or by options",
       folder_options(), true, open_folder, nullptr},
      {"synthetic", "built-in scenes of boxes and cylinders on a table, with the noise of a Kinect v1",
       synthetic_options(), false, open_synthetic, nullptr},
      {"tum", "a sequence of the TUM RGB-D benchmark: depth.txt, rgb.txt, groundtruth.txt", tum_options(),
       true, open_tum, nullptr, is_tum},
      {"seven_scenes", "a sequence of 7-Scenes: frame-NUMBER.depth.png and .pose.txt", seven_scenes_options(),
       true, open_seven_scenes, nullptr, is_seven_scenes},
      {"azure_mkv", "an .mkv that the Azure Kinect's recorder wrote: its depth track", azure_mkv_options(),
       true, open_azure_mkv, nullptr, is_mkv},
      {"benchmark",
       "a synthetic benchmark with truth: its spec (rendered when read) or a folder written from it",
       benchmark_options(), true, open_benchmark, inspect_benchmark, is_benchmark},
  }};
  return table;
}

const ReaderInfo& find_reader(std::string_view name) {
  std::string known;
  for (const ReaderInfo& reader : readers()) {
    if (reader.name == name) return reader;
    known += (known.empty() ? "" : ", ") + std::string(reader.name);
  }
  throw Error(ErrorKind::config, "no reader is called '" + std::string(name) + "'; there are: " + known);
}

std::unique_ptr<Dataset> open_dataset(const DatasetSpec& spec) {
  const ReaderInfo& reader = find_reader(spec.reader);
  check_options(spec.options, reader.options, "data set '" + spec.name + "'");
  return reader.open(spec);
}

}  // namespace facet
