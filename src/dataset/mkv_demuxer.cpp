#include "dataset/mkv_demuxer.hpp"

#include <span>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

namespace facet {
namespace {

constexpr std::uint32_t depth_fourcc = MKTAG('b', '1', '6', 'g');
constexpr AVRational microseconds{1, 1000000};

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& rule) {
  throw Error(ErrorKind::data, printable(path) + ": " + rule);
}

std::string tag(const AVDictionary* tags, const char* name) {
  const AVDictionaryEntry* entry = av_dict_get(tags, name, nullptr, 0);
  return entry == nullptr ? "" : entry->value;
}

std::span<AVStream*> streams_of(const AVFormatContext& context) {
  return {context.streams, context.nb_streams};
}

std::string error_text(int code) {
  char text[AV_ERROR_MAX_STRING_SIZE] = {};
  av_strerror(code, text, sizeof text);
  return text;
}

/// The depth track; all others are not read.
AVStream* choose_track(const AVFormatContext& context) {
  AVStream* chosen = nullptr;
  for (AVStream* stream : streams_of(context)) {
    const bool is_depth =
        stream->codecpar->codec_type == AVMEDIA_TYPE_VIDEO && tag(stream->metadata, "title") == "DEPTH";
    if (is_depth && chosen == nullptr)
      chosen = stream;
    else
      stream->discard = AVDISCARD_ALL;
  }
  return chosen;
}

struct PacketDeleter {
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};

}  // namespace

void MkvDemuxer::Closer::operator()(AVFormatContext* context) const {
  avformat_close_input(&context);
}

MkvDemuxer::MkvDemuxer(const std::filesystem::path& path) {
  av_log_set_level(AV_LOG_QUIET);  // what is wrong with a file is said by what is thrown and counted here
  if (!std::filesystem::is_regular_file(path)) fail(path, "file is missing");
  AVFormatContext* context = nullptr;
  const int code = avformat_open_input(&context, path.c_str(), av_find_input_format("matroska"), nullptr);
  if (code < 0) fail(path, "no readable Matroska file: " + error_text(code));
  context_.reset(context);
  track_ = choose_track(*context);
  if (track_ == nullptr) fail(path, "no track is called DEPTH; is it a recording of an Azure Kinect?");
  const AVCodecParameters& format = *track_->codecpar;
  if (format.codec_tag != depth_fourcc)
    fail(path, "the track DEPTH is not of 16-bit big-endian images (b16g)");
  if (format.width <= 0 || format.height <= 0 || format.width > 4096 || format.height > 4096)
    fail(path, "the track DEPTH has images of " + std::to_string(format.width) + "x" +
                   std::to_string(format.height));
}

std::string libavformat_version() {
  const unsigned version = avformat_version();
  return std::to_string(AV_VERSION_MAJOR(version)) + '.' + std::to_string(AV_VERSION_MINOR(version)) + '.' +
         std::to_string(AV_VERSION_MICRO(version));
}

MkvDepthInfo MkvDemuxer::describe() const {
  MkvDepthInfo info;
  info.size = {track_->codecpar->width, track_->codecpar->height};
  info.depth_mode = tag(track_->metadata, "K4A_DEPTH_MODE");
  if (info.depth_mode.empty()) info.depth_mode = tag(context_->metadata, "K4A_DEPTH_MODE");
  for (const AVStream* stream : streams_of(*context_)) {
    const AVCodecParameters& part = *stream->codecpar;
    if (part.codec_type == AVMEDIA_TYPE_ATTACHMENT && tag(stream->metadata, "filename") == "calibration.json")
      info.calibration_json.assign(reinterpret_cast<const char*>(part.extradata),
                                   static_cast<std::size_t>(part.extradata_size));
  }
  return info;
}

double MkvDemuxer::announced_duration_s() const {
  return context_->duration == AV_NOPTS_VALUE ? 0 : static_cast<double>(context_->duration) / AV_TIME_BASE;
}

std::optional<MkvPacket> MkvDemuxer::next() {
  const std::unique_ptr<AVPacket, PacketDeleter> packet(av_packet_alloc());
  while (packet && av_read_frame(context_.get(), packet.get()) >= 0) {
    if (packet->stream_index == track_->index && packet->pts != AV_NOPTS_VALUE) {
      MkvPacket result{av_rescale_q(packet->pts, track_->time_base, microseconds), {}};
      if (packet->size > 0) result.bytes.assign(packet->data, packet->data + packet->size);
      return result;
    }
    av_packet_unref(packet.get());
  }
  return std::nullopt;
}

void MkvDemuxer::seek(std::int64_t time_us) {
  av_seek_frame(context_.get(), track_->index, av_rescale_q(time_us, microseconds, track_->time_base),
                AVSEEK_FLAG_BACKWARD);
}

}  // namespace facet
