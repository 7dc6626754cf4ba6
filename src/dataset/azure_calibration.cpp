#include "dataset/azure_calibration.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace facet {
namespace {

using Json = nlohmann::json;

/// The camera at a place: D0 is the depth camera.
const Json& camera_at(const Json& calibration, std::string_view place, const std::string& context) {
  for (const Json& camera : calibration.at("CalibrationInformation").at("Cameras"))
    if (camera.at("Location").get<std::string>().ends_with(place)) return camera;
  throw Error(ErrorKind::data, context + ": no camera at " + std::string(place));
}

std::vector<double> parameters_of(const Json& intrinsics, const std::string& context) {
  const auto parameters = intrinsics.at("ModelParameters").get<std::vector<double>>();
  bool finite = true;
  for (const double value : parameters) finite = finite && std::isfinite(value);
  if (!finite || parameters.size() < 14 || parameters.size() > 15)
    throw Error(ErrorKind::data, context + ": ModelParameters: expected 14 or 15 finite numbers");
  return parameters;
}

}  // namespace

std::span<const AzureDepthMode> azure_depth_modes() {
  static constexpr std::array<AzureDepthMode, 4> modes{{
      {"NFOV_UNBINNED", {640, 576}, 1024, 192, 180},
      {"NFOV_2X2BINNED", {320, 288}, 512, 96, 90},
      {"WFOV_2X2BINNED", {512, 512}, 512, 0, 0},
      {"WFOV_UNBINNED", {1024, 1024}, 1024, 0, 0},
  }};
  return modes;
}

const AzureDepthMode* azure_mode_of_size(Size size) {
  for (const AzureDepthMode& mode : azure_depth_modes())
    if (mode.size == size) return &mode;
  return nullptr;
}

LensModel azure_depth_lens(std::string_view json, const AzureDepthMode& mode, const std::string& context) {
  while (json.ends_with('\0')) json.remove_suffix(1);  // the recorder keeps the text's terminator
  try {
    const Json calibration = Json::parse(json);
    const Json& camera = camera_at(calibration, "D0", context);
    const Json& intrinsics = camera.at("Intrinsics");
    const std::vector<double> p = parameters_of(intrinsics, context);
    LensModel lens;
    // Parameters are fractions of the whole sensor, counted from its corner; pixel centres are whole here.
    const double side = mode.binned_px;
    lens.camera = {static_cast<float>(p[2] * side), static_cast<float>(p[3] * side),
                   static_cast<float>(p[0] * side - mode.crop_x - 0.5),
                   static_cast<float>(p[1] * side - mode.crop_y - 0.5)};
    std::copy_n(p.begin() + 4, 6, lens.k);
    lens.centre_x = p[10];
    lens.centre_y = p[11];
    lens.p2 = p[12];
    lens.p1 = p[13];
    lens.halved_cross_terms = intrinsics.value("ModelType", "").ends_with("Rational6KT");
    lens.largest_radius = p.size() > 14 ? p[14] : camera.value("MetricRadius", 0.0);
    return lens;
  } catch (const Json::exception& e) {
    throw Error(ErrorKind::data, context + ": no calibration of an Azure Kinect: " + e.what());
  }
}

}  // namespace facet
