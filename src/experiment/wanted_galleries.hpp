#pragma once

#include "experiment/gallery_pictures.hpp"
#include "record/run_record.hpp"

namespace facet {

/// A gallery that an experiment asks for.
struct WantedGallery {
  const char* file;                    ///< where its entries are stored, below the run directory
  const char* why_empty;               ///< what is noted where it has no entry
  std::vector<GalleryEntry> entries;   ///< not drawn yet
  decltype(&draw_gallery) draw;        ///< draws them
  decltype(&RunRecord::gallery) kept;  ///< where a stored run has them
};

/// Those of a run, or of one of its shards. An entry of the whole is one of its shard too, because entries
/// are the first of an order that does not depend on the other frames.
std::vector<WantedGallery> wanted_galleries(const OutputOptions& outputs, const std::vector<FrameRow>& rows);

}  // namespace facet
