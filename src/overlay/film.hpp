#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace facet {

/// Why this program cannot write films; empty where it can.
std::string film_obstacle();

/// Writes picture files as a film: Motion JPEG in an .avi file, which takes no codec of the machine. Each
/// picture is shown for the same time, a whole number of pictures per second (1 to 60) near `rate_hz`, in the
/// size of the first, at most 1280 px wide; one of another shape has white beside it. The film is published
/// whole or not at all. Returns the rate it has. Throws Error{not_measured} where there is an obstacle,
/// Error{data} for a picture that cannot be read, Error{internal} where the disk is full or the place is not
/// writable. Needs one picture at least.
int write_film(const std::filesystem::path& film, const std::vector<std::filesystem::path>& pictures,
               double rate_hz);

/// A picture and the line above it.
struct TitledPicture {
  std::string title;
  std::filesystem::path file;
};

/// Pictures of a sequence beside and below each other in reading order. 8-bit BGR. Throws Error{data} for a
/// picture that cannot be read. Needs one at least.
cv::Mat draw_contact_sheet(const std::vector<TitledPicture>& pictures);

}  // namespace facet
