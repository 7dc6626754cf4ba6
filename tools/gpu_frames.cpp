#include "gpu_frames.hpp"

#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "synth/synthetic_frame.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;

constexpr int frames_of_a_scene = 8;  ///< one after the other: the temporal average sees a still camera

std::size_t row_bytes(const RawFrame& frame) {
  return sizeof(std::uint16_t) * static_cast<std::size_t>(frame.depth.width());
}

RawFrame read_raw_frame(const std::filesystem::path& folder, const Json& entry) {
  RawFrame frame;
  frame.name = entry.at("name").get<std::string>();
  const Size size{entry.at("width").get<int>(), entry.at("height").get<int>()};
  const auto camera = entry.at("camera_px").get<std::vector<float>>();
  frame.unit_m = entry.at("unit_m").get<double>();
  if (size.empty() || size.area() > (1 << 26) || camera.size() != 4 || !(frame.unit_m > 0))
    throw Error(ErrorKind::data,
                fmt::format("frames.json: {}: a size, fx fy cx cy and a unit are needed", frame.name));
  frame.camera = {camera[0], camera[1], camera[2], camera[3]};
  frame.depth.resize(size);
  const std::filesystem::path file = folder / (frame.name + ".u16");
  std::ifstream input(file, std::ios::binary);
  for (int y = 0; y < size.height; ++y)
    input.read(reinterpret_cast<char*>(frame.depth.row(y)), static_cast<std::streamsize>(row_bytes(frame)));
  if (!input || input.peek() != std::ifstream::traits_type::eof())
    throw Error(ErrorKind::data,
                fmt::format("{}: not {} x {} 16-bit units", file.string(), size.width, size.height));
  return frame;
}

}  // namespace

void decode(const RawFrame& frame, Image<float>& depth_m) {
  depth_m.resize(frame.depth.size());
  for (int y = 0; y < depth_m.height(); ++y)
    for (int x = 0; x < depth_m.width(); ++x) depth_m(x, y) = metres_of(frame.depth(x, y), frame.unit_m);
}

FrameInput input_of(const RawFrame& frame, const Image<float>& depth_m) {
  return {depth_m.view(), frame.camera, {}, {}, DepthCounts{frame.depth.view(), frame.unit_m}};
}

std::vector<RawFrame> render_raw_frames(Size size, int count) {
  std::vector<RawFrame> frames;
  const float scale = static_cast<float>(size.width) / 640;
  const std::vector<View> views = quickstart_views(1);
  for (int i = 0; i < count; ++i) {
    RawFrame frame{
        fmt::format("{}x{}_{:02}", size.width, size.height, i), Image<std::uint16_t>(size), 0.001, {}};
    frame.camera = {525 * scale, 525 * scale, static_cast<float>(size.width - 1) / 2,
                    static_cast<float>(size.height - 1) / 2};
    const View& view = views[static_cast<std::size_t>(i / frames_of_a_scene) % views.size()];
    const Image<float> depth_m =
        measure({}, render(PosedScene(view.scene, view.T_world_camera), frame.camera, size), frame.camera,
                static_cast<std::uint64_t>(i) + 1);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x)
        frame.depth(x, y) =
            static_cast<std::uint16_t>(std::min(65535.0, double{depth_m(x, y)} / frame.unit_m + 0.5));
    frames.push_back(std::move(frame));
  }
  return frames;
}

void write_raw_frames(const std::filesystem::path& folder, const std::vector<RawFrame>& frames) {
  std::filesystem::create_directories(folder);
  Json list = Json::array();
  bool good = true;
  for (const RawFrame& frame : frames) {
    const Camera& c = frame.camera;
    list.push_back({{"name", frame.name},
                    {"width", frame.depth.width()},
                    {"height", frame.depth.height()},
                    {"unit_m", frame.unit_m},
                    {"camera_px", {c.fx, c.fy, c.cx, c.cy}}});
    std::ofstream output(folder / (frame.name + ".u16"), std::ios::binary);
    for (int y = 0; y < frame.depth.height(); ++y)
      output.write(reinterpret_cast<const char*>(frame.depth.row(y)),
                   static_cast<std::streamsize>(row_bytes(frame)));
    good = good && output.flush();
  }
  std::ofstream output(folder / "frames.json");
  output << list.dump(1) << '\n';
  if (!good || !output.flush())
    throw Error(ErrorKind::internal, folder.string() + ": the frames cannot be written");
}

std::vector<RawFrame> read_raw_frames(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "frames.json";
  std::ifstream input(file);
  if (!input) throw Error(ErrorKind::data, file.string() + ": no such file");
  std::vector<RawFrame> frames;
  try {
    for (const Json& entry : Json::parse(input)) frames.push_back(read_raw_frame(folder, entry));
  } catch (const nlohmann::json::exception& e) {
    throw Error(ErrorKind::data, fmt::format("{}: {}", file.string(), e.what()));
  }
  if (frames.empty()) throw Error(ErrorKind::data, file.string() + ": no frames");
  return frames;
}

}  // namespace facet
