#include "prediction/label_images.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"

namespace facet {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& rule) {
  throw Error(ErrorKind::data, printable(path) + ": " + rule);
}

std::string text(Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

cv::Mat read_grey_png(const std::filesystem::path& path, bool allow_16_bit) {
  const ImageFile image = read_image_file(path);
  const std::string expected =
      allow_16_bit ? "expected an 8-bit or 16-bit grey PNG" : "expected an 8-bit grey PNG";
  if (!image.png) fail(path, expected + ", this is no PNG file");
  const int bits = image.png->bit_depth;
  const bool good =
      image.png->is_grey() && (bits == 8 || (allow_16_bit && bits == 16)) && image.pixels.channels() == 1;
  if (!good) fail(path, expected + ", this is a " + image.png->kind());
  return image.pixels;
}

bool is_edge_code(int code) {
  const int kind = code & ~graspable_edge_bit;
  return code == 0 ||
         (kind >= static_cast<int>(EdgeKind::depth) && kind <= static_cast<int>(EdgeKind::concave));
}

struct LabelPixels {
  int area_px = 0;
  bool touches_border = false;
};

std::map<int, LabelPixels> pixels_of_labels(const Image<std::uint16_t>& labels) {
  std::map<int, LabelPixels> found;
  const Size size = labels.size();
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (labels(x, y) == 0) continue;
      LabelPixels& label = found[labels(x, y)];
      ++label.area_px;
      label.touches_border |= x == 0 || y == 0 || x == size.width - 1 || y == size.height - 1;
    }
  }
  return found;
}

}  // namespace

cv::Mat as_mat(const Image<std::uint16_t>& image) {
  return {image.height(), image.width(), CV_16U, const_cast<std::uint16_t*>(image.row(0)),
          image.stride() * sizeof(std::uint16_t)};
}

cv::Mat as_mat(const Image<std::uint8_t>& image) {
  return {image.height(), image.width(), CV_8U, const_cast<std::uint8_t*>(image.row(0)),
          static_cast<std::size_t>(image.stride())};
}

Image<std::uint16_t> read_label_image(const std::filesystem::path& path) {
  const cv::Mat stored = read_grey_png(path, true);
  Image<std::uint16_t> labels(Size{stored.cols, stored.rows});
  cv::Mat target = as_mat(labels);
  stored.convertTo(target, CV_16U);
  return labels;
}

void require_size(const std::filesystem::path& path, Size labels, Size frame) {
  if (labels != frame) fail(path, "is " + text(labels) + " but the frame is " + text(frame));
}

Image<std::uint8_t> read_edge_image(const std::filesystem::path& path, Size size) {
  const cv::Mat stored = read_grey_png(path, false);
  if (Size{stored.cols, stored.rows} != size)
    fail(path, "is " + text({stored.cols, stored.rows}) + " but the label image is " + text(size));
  Image<std::uint8_t> edges(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      edges(x, y) = stored.at<std::uint8_t>(y, x);
      if (!is_edge_code(edges(x, y)))
        fail(path, "unknown edge code " + std::to_string(edges(x, y)) + " at pixel (" + std::to_string(x) +
                       ", " + std::to_string(y) + "); 0 to 3 and 17 to 19 are known");
    }
  }
  return edges;
}

void complete_surfaces(const std::filesystem::path& path, Prediction& prediction) {
  auto labels = pixels_of_labels(prediction.labels);
  for (Surface& surface : prediction.surfaces) {
    const std::string name = "surface " + std::to_string(surface.id);
    const auto label = labels.extract(surface.id);
    if (label.empty()) fail(path, name + " is not in the label image, or is listed twice");
    const LabelPixels& pixels = label.mapped();
    if (surface.area_px != 0 && surface.area_px != pixels.area_px)
      fail(path, name + ": area_px is " + std::to_string(surface.area_px) + " but the label image has " +
                     std::to_string(pixels.area_px) + " of its pixels");
    surface.area_px = pixels.area_px;
    surface.touches_border = pixels.touches_border;
  }
  for (const auto& [id, pixels] : labels) {
    Surface surface;
    surface.id = id;
    surface.area_px = pixels.area_px;
    surface.touches_border = pixels.touches_border;
    surface.no_pose_reason = pose_not_provided;
    prediction.surfaces.push_back(surface);
  }
  std::sort(prediction.surfaces.begin(), prediction.surfaces.end(),
            [](const Surface& a, const Surface& b) { return a.id < b.id; });
}

}  // namespace facet
