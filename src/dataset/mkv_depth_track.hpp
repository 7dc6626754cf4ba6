#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/image_view.hpp"

namespace facet {

/// What a Matroska file that an Azure Kinect recorded holds of depth.
struct MkvDepthInfo {
  Size size;
  std::string depth_mode;                ///< as tagged; empty where it is not
  std::string calibration_json;          ///< the attachment; empty where there is none
  std::vector<std::int64_t> times_us;    ///< of the whole frames, ascending
  std::size_t duplicates = 0;            ///< frames left out: another has their time
  std::size_t out_of_order = 0;          ///< frames that follow a later one in the file
  std::size_t broken = 0;                ///< frames left out: of another size than the track's
  std::optional<double> ends_early_s{};  ///< how much of the announced duration is not there
};

/// The track DEPTH of a recording: big-endian 16-bit images, uncompressed.
class MkvDepthTrack {
 public:
  virtual ~MkvDepthTrack() = default;
  virtual const MkvDepthInfo& info() const = 0;
  /// The bytes of the frame at a time of the list, most significant byte first. May be called from several
  /// threads. Throws Error{data} where the file has changed and they are not there any more.
  virtual std::vector<std::uint8_t> read(std::int64_t time_us) = 0;
};

/// Opens a recording and lists its frames. Throws Error{data} naming file and rule where it is none, or has
/// no depth track; Error{not_measured} where this build has no libavformat.
std::unique_ptr<MkvDepthTrack> open_mkv_depth_track(const std::filesystem::path& path);

/// The version of FFmpeg's libavformat that reads recordings; empty where this build has none.
std::string libavformat_version();

}  // namespace facet
