#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace facet {

/// Writes Matroska files in the form of the Azure Kinect's recorder, for tests.
class MkvWriter {
 public:
  struct Track {
    std::string name = "DEPTH";
    std::string fourcc = "b16g";
    int width = 320, height = 288;
  };
  struct Frame {
    std::uint64_t time_us = 0;
    std::string bytes;
    int track = 0;
  };
  std::vector<Track> tracks{{}};
  std::vector<Frame> frames;
  std::string depth_mode = "NFOV_2X2BINNED";  ///< empty: no tag
  std::string calibration;                    ///< empty: no attachment
  double duration_us = 0;

  std::string text() const {
    std::string segment =
        element(0x1549A966, unsigned_element(0x2AD7B1, 1000) + float_element(0x4489, duration_us));
    std::string entries;
    for (std::size_t i = 0; i < tracks.size(); ++i) entries += track_entry(tracks[i], i + 1);
    segment += element(0x1654AE6B, entries);
    if (!calibration.empty())
      segment += element(
          0x1941A469,
          element(0x61A7, element(0x466E, "calibration.json") + element(0x4660, "application/octet-stream") +
                              element(0x465C, calibration) + unsigned_element(0x46AE, 7)));
    if (!depth_mode.empty())
      segment += element(0x1254C367, element(0x7373, element(0x63C0, unsigned_element(0x63C5, 1)) +
                                                         element(0x67C8, element(0x45A3, "K4A_DEPTH_MODE") +
                                                                             element(0x4487, depth_mode))));
    for (const Frame& frame : frames)  // one frame per cluster: offsets within one reach 32 ms only
      segment += element(0x1F43B675, unsigned_element(0xE7, frame.time_us) +
                                         element(0xA3, std::string{static_cast<char>(0x81 + frame.track), 0,
                                                                   0, static_cast<char>(0x80)} +
                                                           frame.bytes));
    const std::string head = unsigned_element(0x4286, 1) + unsigned_element(0x42F7, 1) +
                             unsigned_element(0x42F2, 4) + unsigned_element(0x42F3, 8) +
                             element(0x4282, "matroska") + unsigned_element(0x4287, 4) +
                             unsigned_element(0x4285, 2);
    return element(0x1A45DFA3, head) + element(0x18538067, segment);
  }
  void write(const std::filesystem::path& path) const { std::ofstream(path, std::ios::binary) << text(); }

 private:
  static std::string big_endian(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 0xff);
    return text;
  }
  static std::string element(std::uint32_t id, std::string_view content) {
    const int id_bytes = id > 0xffffff ? 4 : id > 0xffff ? 3 : id > 0xff ? 2 : 1;
    return big_endian(id, id_bytes) + big_endian(content.size() | std::uint64_t{1} << 56, 8) +
           std::string(content);
  }
  static std::string unsigned_element(std::uint32_t id, std::uint64_t value) {
    return element(id, big_endian(value, 8));
  }
  static std::string float_element(std::uint32_t id, double value) {
    return element(id, big_endian(std::bit_cast<std::uint64_t>(value), 8));
  }
  static std::string little_endian(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xff);
    return text;
  }
  static std::string track_entry(const Track& track, std::uint64_t number) {
    const auto width = static_cast<std::uint32_t>(track.width),
               height = static_cast<std::uint32_t>(track.height);
    const std::string bitmap = little_endian(40, 4) + little_endian(width, 4) + little_endian(height, 4) +
                               little_endian(1, 2) + little_endian(16, 2) + track.fourcc +
                               little_endian(2 * width * height, 4) + std::string(16, '\0');
    return element(0xAE, unsigned_element(0xD7, number) + unsigned_element(0x73C5, number) +
                             unsigned_element(0x83, 1) + unsigned_element(0x9C, 0) +
                             element(0x536E, track.name) + element(0x86, "V_MS/VFW/FOURCC") +
                             element(0x63A2, bitmap) +
                             element(0xE0, unsigned_element(0xB0, width) + unsigned_element(0xBA, height)));
  }
};

}  // namespace facet
