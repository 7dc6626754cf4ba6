#include "file/image_file.hpp"

#include <opencv2/imgcodecs.hpp>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

cv::Mat decode(const std::vector<std::uint8_t>& bytes, const std::filesystem::path& path) {
  cv::Mat pixels;
  try {
    pixels = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception& e) {
    throw Error(ErrorKind::data, printable(path) + ": image cannot be decoded: " + e.err);
  }
  if (pixels.empty())
    throw Error(ErrorKind::data,
                printable(path) + ": image cannot be decoded (corrupt, or of an unknown format)");
  return pixels;
}

}  // namespace

ImageFile read_image_file(const std::filesystem::path& path) {
  const auto bytes = read_file_bytes(path);
  ImageFile image;
  if (is_png(bytes)) {
    std::string problem;
    image.png = check_png(bytes, problem);
    if (!image.png) throw Error(ErrorKind::data, printable(path) + ": " + problem);
  }
  image.pixels = decode(bytes, path);
  return image;
}

void write_png_file(const std::filesystem::path& path, const cv::Mat& pixels, PngEffort effort) {
  std::vector<std::uint8_t> bytes;
  // Settings are spelled out, because the library's defaults differ from version to version. Without a level
  // it takes zlib's fastest, and one filter in place of the best of five for each row.
  std::vector<int> settings{cv::IMWRITE_PNG_STRATEGY, cv::IMWRITE_PNG_STRATEGY_DEFAULT};
  if (effort == PngEffort::least_space) settings.insert(settings.end(), {cv::IMWRITE_PNG_COMPRESSION, 6});
  if (!cv::imencode(".png", pixels, bytes, settings))
    throw Error(ErrorKind::internal, printable(path) + ": image cannot be encoded");
  write_file_atomically(path, bytes);
}

}  // namespace facet
