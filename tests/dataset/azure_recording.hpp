#pragma once

#include <cstdint>
#include <string>

#include "core/image.hpp"

namespace facet {

/// The calibration of a depth camera as recordings have it; `k1` bends the lens.
inline std::string calibration_text(double k1 = 0, const std::string& type = "BrownConrady") {
  return R"({"CalibrationInformation": {"Cameras": [
    {"Location": "CALIBRATION_CameraLocationPV0", "Intrinsics": {"ModelParameters": []}},
    {"Location": "CALIBRATION_CameraLocationD0", "MetricRadius": 1.7, "SensorWidth": 1024, "SensorHeight": 1024,
     "Intrinsics": {"ModelType": "CALIBRATION_LensDistortionModel)" +
         type + R"(", "ModelParameterCount": 14,
       "ModelParameters": [0.5, 0.515625, 0.4921875, 0.494140625, )" +
         std::to_string(k1) + R"(, 0, 0, 0, 0, 0, 0, 0, 0, 0]}}]}})";
}

/// A depth image [mm] as the track has it: 16 bits, most significant byte first.
inline std::string big_endian_bytes(const Image<std::uint16_t>& depth_mm) {
  std::string bytes;
  for (int y = 0; y < depth_mm.height(); ++y)
    for (int x = 0; x < depth_mm.width(); ++x) {
      bytes += static_cast<char>(depth_mm(x, y) >> 8);
      bytes += static_cast<char>(depth_mm(x, y) & 0xff);
    }
  return bytes;
}

/// A depth image in which no two neighbours and no two frames agree.
inline Image<std::uint16_t> depth_pattern(Size size, int frame) {
  Image<std::uint16_t> depth_mm(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      depth_mm(x, y) = static_cast<std::uint16_t>(
          (x * 7 + y * 13 + frame * 101) % 5 == 0 ? 0 : 700 + (x * 31 + y * 17 + frame * 257) % 3000);
  return depth_mm;
}

}  // namespace facet
