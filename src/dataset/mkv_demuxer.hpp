#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "dataset/mkv_depth_track.hpp"

struct AVFormatContext;
struct AVStream;

namespace facet {

/// One frame of the depth track as it stands in the file.
struct MkvPacket {
  std::int64_t time_us = 0;
  std::vector<std::uint8_t> bytes;
};

/// The depth track of a Matroska file by way of libavformat, packet by packet.
class MkvDemuxer {
 public:
  /// Throws Error{data} naming file and rule where it cannot be opened or has no depth track.
  explicit MkvDemuxer(const std::filesystem::path& path);

  /// Size, mode and calibration; lists no frames.
  MkvDepthInfo describe() const;
  double announced_duration_s() const;  ///< 0 where the file does not say
  /// The next frame of the track, nothing at the end of what can be read.
  std::optional<MkvPacket> next();
  /// Goes to the frame at a time, or to one before it; where the file cannot be searched, stays.
  void seek(std::int64_t time_us);

 private:
  struct Closer {
    void operator()(AVFormatContext* context) const;
  };
  std::unique_ptr<AVFormatContext, Closer> context_;
  AVStream* track_ = nullptr;
};

}  // namespace facet
