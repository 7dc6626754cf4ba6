#include "method/program_files.hpp"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"
#include "method/program.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

bool asks_for(const ExternalParams& params, const char* placeholder) {
  return params.command.find(placeholder) != std::string::npos;
}

cv::Mat depth_units(const Image<float>& depth_m, float unit_mm) {
  cv::Mat units(depth_m.height(), depth_m.width(), CV_16U);
  for (int y = 0; y < units.rows; ++y)
    for (int x = 0; x < units.cols; ++x) {
      const float value = std::round(depth_m(x, y) * 1000 / unit_mm);
      if (value > static_cast<float>(std::numeric_limits<std::uint16_t>::max()))
        throw Error(ErrorKind::data,
                    fmt::format("a depth of {:g} m does not fit into 16 bits: raise depth_unit_mm from {:g}",
                                depth_m(x, y), unit_mm));
      units.at<std::uint16_t>(y, x) = static_cast<std::uint16_t>(value);
    }
  return units;
}

std::string intrinsics_json(const Frame& frame, const ExternalParams& params) {
  nlohmann::ordered_json json;
  json["width"] = frame.depth_m.width();
  json["height"] = frame.depth_m.height();
  json["fx"] = frame.camera.fx;
  json["fy"] = frame.camera.fy;
  json["cx"] = frame.camera.cx;
  json["cy"] = frame.camera.cy;
  json["depth_unit_m"] = static_cast<double>(params.depth_unit_mm) / 1000;
  return json.dump() + '\n';
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::string pattern = (fs::temp_directory_path() / "facet_XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr)
    throw Error(ErrorKind::internal, fmt::format("{}: cannot be made: {}", pattern, std::strerror(errno)));
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;  // what a program has made unremovable stays
  fs::remove_all(path_, ignored);
}

ProgramFiles ProgramFiles::folders_in(const fs::path& folder, const fs::path& out) {
  return {folder / "depth", folder / "color", folder / "intrinsics", out};
}

ProgramFiles ProgramFiles::of_frame(const std::string& name) const {
  return {depth / (name + ".png"), color / (name + ".png"), intrinsics / (name + ".json"), out / name};
}

void write_program_input(const Frame& frame, const ExternalParams& params, const ProgramFiles& files) {
  write_png_file(files.depth, depth_units(frame.depth_m, params.depth_unit_mm), PngEffort::least_time);
  if (asks_for(params, "{color}") && !frame.color.empty())
    write_png_file(files.color, frame.color, PngEffort::least_time);
  if (asks_for(params, "{intrinsics}"))
    write_file_atomically(files.intrinsics, intrinsics_json(frame, params));
}

std::string filled_command(const ExternalParams& params, const ProgramFiles& files) {
  std::string command = params.command;
  const auto fill = [&command](const std::string& placeholder, const fs::path& path) {
    const std::string word = shell_quoted(fs::absolute(path).string());
    for (std::size_t at = 0; (at = command.find(placeholder, at)) != command.npos; at += word.size())
      command.replace(at, placeholder.size(), word);
  };
  fill("{depth}", files.depth);
  fill("{color}", files.color);
  fill("{intrinsics}", files.intrinsics);
  fill("{out}", files.out);
  return command;
}

void check_command(const ExternalParams& params, const std::string& method) {
  for (const char* placeholder : {"{depth}", "{out}"})
    if (!asks_for(params, placeholder))
      throw Error(ErrorKind::config, fmt::format("method '{}': its command has no {}: \"{}\"", method,
                                                 placeholder, params.command));
}

}  // namespace facet
