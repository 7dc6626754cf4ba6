#include "dataset/frame_loader.hpp"

#include "core/error.hpp"
#include "dataset/depth_image.hpp"
#include "dataset/frame_checks.hpp"

namespace facet {
namespace {

/// Collects the problems of a frame's files, so that one message names all of them.
class ProblemList {
 public:
  template <class Step>
  void attempt(Step&& step) {
    try {
      step();
    } catch (const Error& e) {
      message_ += (message_.empty() ? "" : "; ") + std::string(e.what());
    }
  }
  void throw_if_any() const {
    if (!message_.empty()) throw Error(ErrorKind::data, message_);
  }

 private:
  std::string message_;
};

void load_depth(Frame& frame, const std::filesystem::path& path, const DepthFormat& format) {
  DepthImage depth = read_depth_image(path, format.unit_m, format.missing_codes);
  frame.depth_m = std::move(depth.depth_m);
  frame.counted = std::move(depth.counted);
  frame.missing_px = depth.missing_px;
}

}  // namespace

Frame load_frame(const std::string& id, const FrameFiles& files, const DepthFormat& format,
                 const Camera& camera) {
  Frame frame;
  frame.id = id;
  frame.camera = camera;
  frame.files = {files.depth};
  ProblemList problems;
  problems.attempt([&] { load_depth(frame, files.depth, format); });
  // Without a depth image its size is unknown; the other files are still tried.
  const Size size = frame.depth_m.size();
  if (!size.empty()) {
    problems.attempt([&] { check_camera(camera, size, files.depth); });
    problems.attempt([&] { check_depth_unit(frame.depth_m, files.depth); });
  }
  if (files.color) {
    problems.attempt([&] { frame.color = read_registered_color(*files.color, size); });
    frame.files.push_back(*files.color);
  }
  if (files.object_masks) {
    problems.attempt([&] { frame.object_masks = read_object_masks(*files.object_masks, size); });
    frame.files.push_back(*files.object_masks);
  }
  problems.throw_if_any();
  return frame;
}

}  // namespace facet
