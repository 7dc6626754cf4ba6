#pragma once

#include <string>

namespace facet {

/// What the folder of a method of kind `predictions` holds beside, or in place of, label images. Names are
/// relative to the folder.
struct StoredParams {
  std::string poses;                    ///< a CSV of poses, as the BOP challenge has them; empty: none
  std::string instances;                ///< a JSON of COCO instances, in place of label images; empty: none
  std::string frame_id = "{im_id:06}";  ///< the frame that their numbers name
};

}  // namespace facet
