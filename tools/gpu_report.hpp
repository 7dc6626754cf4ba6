#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cuda/cuda_floor.hpp"
#include "gpu_measurements.hpp"

namespace facet {

/// What was measured at one image size.
struct SizeReport {
  Size size;
  int scenes_frames = 0;  ///< different frames
  Latency latency;        ///< a frame at a time
  Throughput side_by_side;
  Latency cpu;                                       ///< of the CPU back end, on one thread
  std::optional<std::array<int, stage_count>> work;  ///< kernels and copies of each stage; none on the CPU
};

/// Everything that one run of the check has found.
struct GpuReport {
  std::vector<std::pair<std::string, std::string>> facts;  ///< machine, build, tests: key and text
  std::optional<CudaFloor> floor;                          ///< none on the CPU
  int compared_frames = 0;
  std::vector<std::string> differing;  ///< frames whose results are not those of the CPU
  int runs = 0, distinct = 0;          ///< of one frame, and the different results they had
  std::vector<SizeReport> sizes;
  Throughput batch;
  double decoded_per_s = 0;  ///< by one thread
};

std::string to_json(const GpuReport& report);
std::string to_markdown(const GpuReport& report);

}  // namespace facet
