#pragma once

#include "score/region_match.hpp"
#include "score/tally.hpp"

namespace facet {

/// How regions respect the visible objects of the masks.
struct ObjectMaskScore {
  Tally leakage;   ///< object pixels in regions most of which belong to another object, or to none; less is
                   ///< better
  Tally coverage;  ///< object pixels that lie in some region
  Tally outline_recall;     ///< pixels of the objects' outlines near the outline of a region
  Tally outline_precision;  ///< pixels of the compared regions' outlines near the outline of an object
};

/// "Near" as in the boundary scores: boundary_radius_px().
ObjectMaskScore score_object_masks(const RegionComparison& comparison);

}  // namespace facet
