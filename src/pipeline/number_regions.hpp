#pragma once

#include <utility>

#include "pipeline/buffers.hpp"
#include "pipeline/params.hpp"
#include "stage/labelling.hpp"
#include "surface/regions.hpp"

namespace facet {

/// Finds the components of what is measured and no edge, and numbers them (see RegionNumbering): writes
/// b.label and, for contours that are those of the edge map, `numbered`, which has the frame's size. Returns
/// the number of labels.
template <class Executor>
int number_regions(Executor& executor, Buffers<Executor>& b, const PipelineParams& params,
                   const Camera& camera, RegionNumbering& numbering, Image<std::uint16_t>& numbered,
                   std::vector<RejectedRegion>& rejected) {
  label_components(executor, b.depth.view(), b.edge.view(), b.root.view());
  const int count =
      numbering.number(executor.on_host(b.root), executor.on_host(b.depth), executor.on_host(b.filled),
                       camera, params.validation, numbered.view(), rejected);
  executor.upload(std::as_const(numbered).view(), b.label.view());
  return count;
}

}  // namespace facet
