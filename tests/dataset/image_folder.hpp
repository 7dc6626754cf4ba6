#pragma once

#include <cstdint>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "support/temporary_folder.hpp"

namespace facet {

/// A folder into which a test writes small images.
class ImageFolder {
 public:
  const std::filesystem::path& path() const { return folder_.path(); }

  void write(const std::string& name, const cv::Mat& image) const {
    const auto file = path() / name;
    std::filesystem::create_directories(file.parent_path());
    cv::imwrite(file, image);
  }
  /// 16-bit depth of one value [raw units].
  void write_depth(const std::string& name, int value, int width = 32, int height = 24) const {
    write(name, cv::Mat(height, width, CV_16U, cv::Scalar(value)));
  }
  void write_color(const std::string& name, int width = 32, int height = 24) const {
    write(name, cv::Mat(height, width, CV_8UC3, cv::Scalar(10, 20, 30)));
  }
  /// Cuts a file to the first half of its bytes.
  void truncate(const std::string& name) const {
    const auto file = path() / name;
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace facet
