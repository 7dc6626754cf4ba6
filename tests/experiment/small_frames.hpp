#pragma once

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

namespace facet {

/// A folder data set of small frames, each with a raised square on a plane, and an experiment that runs over
/// it.
inline void write_small_frames(const std::filesystem::path& folder, const std::vector<std::string>& ids) {
  std::filesystem::create_directories(folder);
  int shift = 0;
  for (const std::string& id : ids) {
    cv::Mat depth(48, 64, CV_16U, cv::Scalar(1000));
    cv::rectangle(depth, {8 + shift++ % 8, 10, 30, 24}, cv::Scalar(900), cv::FILLED);
    cv::imwrite(folder / (id + ".depth.png"), depth);
  }
}

inline const std::string small_dataset =
    "datasets:\n  - {name: small, reader: folder, root: frames, depth: \"{id}.depth.png\", depth_unit_m: "
    "0.001, "
    "intrinsics: [60, 60, 31.5, 23.5]}\n";
inline const std::string small_experiment =
    "schema: 1\n" + small_dataset + "methods: [{name: a}, {name: b, params: {wiener.enabled: false}}]\n" +
    "timing: {warmup: 1, repeats: 2}\noutputs: {overlays: false}\n";

}  // namespace facet
