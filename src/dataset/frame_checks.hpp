#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "core/camera.hpp"
#include "core/image.hpp"

namespace facet {

/// Throws Error{data} where intrinsics cannot be right for an image of that size: fx or fy not positive, a
/// focal length outside 0.3 to 5 image widths, a principal point outside the image. `path` opens the message.
void check_camera(const Camera& camera, Size size, const std::filesystem::path& path);

/// Throws Error{data} where the median of the measured depths lies outside 0.1 to 20 m: the unit is wrong. An
/// image without any measured depth passes.
void check_depth_unit(const Image<float>& depth_m, const std::filesystem::path& path);

/// Reads a colour image as 8-bit BGR; throws Error{data} where it is broken or of another size than `size`
/// (an empty `size` is not compared).
cv::Mat read_registered_color(const std::filesystem::path& path, Size size);

/// Reads object masks as CV_16U, 0 = none; throws Error{data} as above, or where they are not grey integers.
cv::Mat read_object_masks(const std::filesystem::path& path, Size size);

}  // namespace facet
