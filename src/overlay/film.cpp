#include "overlay/film.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/videoio.hpp>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"
#include "file/publish_file.hpp"
#include "overlay/panel.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

// OpenCV's own writer and reader: others need codecs of the machine, or round the number of frames.
constexpr int own_writer = cv::CAP_OPENCV_MJPEG;

cv::Size film_size(const cv::Mat& first) {
  constexpr int most_width_px = 1280;
  const double scale = std::min(1.0, static_cast<double>(most_width_px) / first.cols);
  // Players want even sizes.
  const auto even = [scale](int side) { return std::max(2, 2 * static_cast<int>(side * scale / 2)); };
  return {even(first.cols), even(first.rows)};
}

/// The writer says nothing of a full disk: what it wrote is counted.
bool is_whole(const fs::path& film, std::size_t pictures) {
  const cv::VideoCapture written(film.string(), own_writer);
  return written.isOpened() && static_cast<std::size_t>(written.get(cv::CAP_PROP_FRAME_COUNT)) == pictures;
}

}  // namespace

std::string film_obstacle() {
  return {};
}

int write_film(const fs::path& film, const std::vector<fs::path>& pictures, double rate_hz) {
  const int rate = static_cast<int>(std::lround(std::clamp(rate_hz, 1.0, 60.0)));
  publish_file(film, [&](const fs::path& place) {
    cv::VideoWriter writer;
    cv::Size size;
    for (const fs::path& file : pictures) {
      const cv::Mat picture = read_image_file(file).pixels;
      if (!writer.isOpened()) {
        size = film_size(picture);
        writer.open(place.string(), own_writer, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), rate, size);
        if (!writer.isOpened()) throw Error(ErrorKind::internal, printable(film) + ": cannot be written");
      }
      writer.write(fitted(picture, size));
    }
    writer.release();
    if (!is_whole(place, pictures.size()))
      throw Error(ErrorKind::internal, printable(film) + ": cannot be written to its end: disk full?");
  });
  return rate;
}

}  // namespace facet
