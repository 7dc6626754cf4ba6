#include "dataset/mkv_depth_track.hpp"

#include <algorithm>
#include <mutex>

#include "core/error.hpp"
#include "dataset/mkv_demuxer.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

/// Times up to this much past the last frame are its own duration.
constexpr double usual_end_s = 0.25;

class DemuxedTrack : public MkvDepthTrack {
 public:
  explicit DemuxedTrack(const std::filesystem::path& path) : path_(path), demuxer_(path) {
    info_ = demuxer_.describe();
    list_frames();
  }
  const MkvDepthInfo& info() const override { return info_; }

  std::vector<std::uint8_t> read(std::int64_t time_us) override {
    const std::lock_guard lock(mutex_);
    // Mostly the next one; else its place is looked up, else searched for from the beginning.
    if (auto frame = scan_to(time_us)) return std::move(*frame);
    demuxer_.seek(time_us);
    if (auto frame = scan_to(time_us)) return std::move(*frame);
    demuxer_ = MkvDemuxer(path_);
    while (auto packet = demuxer_.next())
      if (packet->time_us == time_us && packet->bytes.size() == frame_bytes())
        return std::move(packet->bytes);
    throw Error(ErrorKind::data, printable(path_) + ": the frame at " + std::to_string(time_us) +
                                     " us cannot be read; has the file changed?");
  }

 private:
  std::size_t frame_bytes() const { return 2 * static_cast<std::size_t>(info_.size.area()); }

  void list_frames() {
    std::int64_t latest_us = INT64_MIN;
    while (const auto packet = demuxer_.next()) {
      if (packet->bytes.size() != frame_bytes()) {
        ++info_.broken;
        continue;
      }
      info_.out_of_order += packet->time_us < latest_us;
      latest_us = std::max(latest_us, packet->time_us);
      info_.times_us.push_back(packet->time_us);
    }
    std::vector<std::int64_t>& times = info_.times_us;
    std::sort(times.begin(), times.end());
    const auto end = std::unique(times.begin(), times.end());
    info_.duplicates = static_cast<std::size_t>(times.end() - end);
    times.erase(end, times.end());
    const double announced_s = demuxer_.announced_duration_s();
    const double last_s = times.empty() ? 0 : static_cast<double>(times.back()) * 1e-6;
    if (announced_s - last_s > usual_end_s) info_.ends_early_s = announced_s - last_s;
  }

  /// Reads on while frames are not later than the wanted one.
  std::optional<std::vector<std::uint8_t>> scan_to(std::int64_t time_us) {
    while (auto packet = demuxer_.next()) {
      if (packet->time_us == time_us && packet->bytes.size() == frame_bytes())
        return std::move(packet->bytes);
      if (packet->time_us > time_us) break;
    }
    return std::nullopt;
  }

  std::filesystem::path path_;
  MkvDemuxer demuxer_;
  MkvDepthInfo info_;
  std::mutex mutex_;
};

}  // namespace

std::unique_ptr<MkvDepthTrack> open_mkv_depth_track(const std::filesystem::path& path) {
  return std::make_unique<DemuxedTrack>(path);
}

}  // namespace facet
