#pragma once

#include <utility>

#include "pipeline/buffers.hpp"
#include "pipeline/params.hpp"
#include "surface/regions.hpp"

namespace facet {

/// Numbers the components in b.root (see RegionNumbering): writes b.label and, for contours that are those of
/// the edge map, `numbered`, which has the frame's size. Returns the number of labels.
template <class Executor>
int number_regions(Executor& executor, Buffers<Executor>& b, const PipelineParams& params,
                   const Camera& camera, RegionNumbering& numbering, Image<std::uint16_t>& numbered,
                   std::vector<RejectedRegion>& rejected) {
  const int count =
      numbering.number(executor.on_host(b.root), executor.on_host(b.depth), executor.on_host(b.filled),
                       camera, params.validation, numbered.view(), rejected);
  executor.upload(std::as_const(numbered).view(), b.label.view());
  return count;
}

}  // namespace facet
