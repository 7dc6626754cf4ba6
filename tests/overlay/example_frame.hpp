#pragma once

#include "dataset/dataset.hpp"
#include "prediction/prediction.hpp"

namespace facet {

/// A frame of a wall at 1 m, without colour.
inline Frame example_frame(Size size) {
  Frame frame;
  frame.id = "example";
  frame.depth_m = Image<float>(size, 1.0f);
  const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
  frame.camera = {width, width, (width - 1) / 2, (height - 1) / 2};
  return frame;
}

/// What a method may make of it: nothing found.
inline Prediction empty_prediction(Size size) {
  Prediction prediction;
  prediction.labels = Image<std::uint16_t>(size, 0);
  prediction.edges = Image<std::uint8_t>(size, 0);
  return prediction;
}

/// One surface in the right half of the image, facing the camera at its centre.
inline Prediction half_prediction(Size size) {
  Prediction prediction = empty_prediction(size);
  Surface surface;
  surface.id = 1;
  for (int y = 0; y < size.height; ++y) {
    for (int x = size.width / 2; x < size.width; ++x) {
      prediction.labels(x, y) = 1;
      ++surface.area_px;
    }
  }
  const int left = size.width / 2, right = size.width - 1, bottom = size.height - 1;
  surface.contour.outer = {{left, 0}, {right, 0}, {right, bottom}, {left, bottom}};
  surface.pose = SurfacePose{{0, 0, 1}, {1, 0, 0, 0}, {}, {1, 0, 0}};
  prediction.surfaces = {surface};
  return prediction;
}

}  // namespace facet
