#include <algorithm>

#include "file/image_file.hpp"
#include "overlay/film.hpp"
#include "overlay/panel.hpp"

namespace facet {

cv::Mat draw_contact_sheet(const std::vector<TitledPicture>& pictures) {
  constexpr std::size_t columns = 2;
  constexpr int width_px = 960;
  std::vector<std::vector<cv::Mat>> rows;
  cv::Size size;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (i % columns == 0) rows.emplace_back();
    const cv::Mat picture = read_image_file(pictures[i].file).pixels;
    if (i == 0) size = {width_px, std::max(1, picture.rows * width_px / picture.cols)};
    rows.back().push_back(with_title(fitted(picture, size), pictures[i].title));
  }
  return panel_grid(rows);
}

}  // namespace facet
