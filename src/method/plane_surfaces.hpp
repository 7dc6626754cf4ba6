#pragma once

#include <vector>

#include "core/depth_noise.hpp"
#include "dataset/dataset.hpp"
#include "prediction/prediction.hpp"

namespace facet {

/// The surfaces of a method that finds planes. `prediction.labels` holds 0 = none and k = on planes[k - 1];
/// planes without a pixel are dropped and the rest numbered anew. Fills `surfaces`: plane turned towards the
/// camera, pose about the mean of its pixels, outline, and how well the plane fits by the sensor's noise.
void describe_planes(const Frame& frame, const DepthNoise& noise, std::vector<Plane> planes,
                     Prediction& prediction);

}  // namespace facet
