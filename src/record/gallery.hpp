#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "record/frame_row.hpp"

namespace facet {

/// A frame that somebody should look at.
struct GalleryEntry {
  std::string dataset, frame, method;
  std::string metric;
  std::optional<double> value;     ///< of the metric in this frame
  std::optional<double> baseline;  ///< the same in another run
  std::string picture;             ///< path relative to the run directory; empty: none could be drawn
};

/// Of every data set and method the `count` frames with the worst value of a metric, worst first; ties in the
/// order of the rows. Frames without a value are left out. Throws Error{usage} listing the metrics where none
/// has that name.
std::vector<GalleryEntry> worst_frames(const std::vector<FrameRow>& rows, const std::string& metric,
                                       std::size_t count);
/// The same by how much worse a frame is than in `baseline`; frames that the baseline lacks are left out.
std::vector<GalleryEntry> worst_frames(const std::vector<FrameRow>& rows,
                                       const std::vector<FrameRow>& baseline, const std::string& metric,
                                       std::size_t count);

/// Of every data set the `count` frames in which a metric differs most between methods, most first: an entry
/// names the method with the best value, with that as `value` and the worst as `baseline`. Frames without two
/// different values are left out. Throws Error{usage} where no metric has that name.
std::vector<GalleryEntry> disputed_frames(const std::vector<FrameRow>& rows, const std::string& metric,
                                          std::size_t count);

/// gallery/gallery.json.
std::string to_json(const std::vector<GalleryEntry>& entries);
/// Throws Error{data} for anything else.
std::vector<GalleryEntry> gallery_from_json(std::string_view text);

}  // namespace facet
