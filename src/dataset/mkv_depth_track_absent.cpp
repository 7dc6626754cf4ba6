// What stands in where FFmpeg's libavformat was not found when the program was built.
#include "core/error.hpp"
#include "dataset/mkv_depth_track.hpp"
#include "file/file_bytes.hpp"

namespace facet {

std::unique_ptr<MkvDepthTrack> open_mkv_depth_track(const std::filesystem::path& path) {
  throw Error(ErrorKind::not_measured,
              printable(path) +
                  ": this binary was built without FFmpeg's libavformat, which reads .mkv; install "
                  "libavformat-dev and libavcodec-dev and build with FACET_LIBAV=ON");
}

std::string libavformat_version() {
  return {};
}

}  // namespace facet
