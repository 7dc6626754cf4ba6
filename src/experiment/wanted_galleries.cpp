#include "experiment/wanted_galleries.hpp"

namespace facet {

std::vector<WantedGallery> wanted_galleries(const OutputOptions& outputs, const std::vector<FrameRow>& rows) {
  const std::string metric = GalleryRequest{}.metric;
  std::vector<WantedGallery> galleries;
  if (outputs.gallery > 0)
    galleries.push_back({"gallery/gallery.json", "no gallery: no frame is scored by its surfaces",
                         worst_frames(rows, metric, static_cast<std::size_t>(outputs.gallery)), draw_gallery,
                         &RunRecord::gallery});
  if (outputs.disputed > 0)
    galleries.push_back({"gallery/disputed.json", "no frame is disputed",
                         disputed_frames(rows, metric, static_cast<std::size_t>(outputs.disputed)),
                         draw_disputed, &RunRecord::disputed});
  return galleries;
}

}  // namespace facet
