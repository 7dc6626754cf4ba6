#pragma once

namespace facet {

enum class ContourMode {
  regions,   ///< outline of every label of the label map: closed whatever the edges do
  edge_map,  ///< the paper: findContours on the edge image; a surface is a hole of the edge network
};

struct ContourParams {
  ContourMode mode = ContourMode::regions;
};

}  // namespace facet
