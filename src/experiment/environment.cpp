#include "experiment/environment.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/core/version.hpp>
#include <openssl/crypto.h>
#include <sstream>
#include <sys/utsname.h>
#include <tbb/version.h>
#include <thread>

#include "dataset/mkv_depth_track.hpp"
#include "experiment/build_info.hpp"
#include "file/file_bytes.hpp"
#include "method/backend.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// The value of the first line "key : value" of a /proc file; empty where there is none.
std::string proc_value(const fs::path& file, const std::string& key) {
  std::ifstream input(file);
  for (std::string line; std::getline(input, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) continue;
    const std::size_t start = line.find_first_not_of(" \t", colon + 1);
    return start == std::string::npos ? "" : escaped_utf8(line.substr(start));
  }
  return {};
}

Json known_or_reason(const std::string& value, const std::string& reason) {
  if (!value.empty()) return value;
  return Json{{"value", nullptr}, {"reason", reason}};
}

std::string first_line(const fs::path& file) {
  std::ifstream input(file);
  std::string line;
  std::getline(input, line);
  return escaped_utf8(line);
}

Json cpu() {
  Json json;
  json["model"] = known_or_reason(proc_value("/proc/cpuinfo", "model name"), "/proc/cpuinfo does not say");
  json["threads"] = std::thread::hardware_concurrency();
  std::string simd;
  std::istringstream flags(proc_value("/proc/cpuinfo", "flags"));
  for (std::string flag; flags >> flag;)
    if (flag == "sse2" || flag == "sse4_2" || flag == "avx" || flag == "avx2" || flag == "fma" ||
        flag == "avx512f")
      simd += (simd.empty() ? "" : " ") + flag;
  json["simd"] = known_or_reason(simd, "/proc/cpuinfo does not say");
  json["governor"] = known_or_reason(first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor"),
                                     "no frequency scaling visible");
  json["memory"] = known_or_reason(proc_value("/proc/meminfo", "MemTotal"), "/proc/meminfo does not say");
  return json;
}

Json gpu() {
  Json json;
  std::string name;
  std::error_code absent;
  for (const auto& card : fs::directory_iterator("/proc/driver/nvidia/gpus", absent))
    if (name.empty()) name = proc_value(card.path() / "information", "Model");
  json["name"] = known_or_reason(name, "no NVIDIA driver loaded");
  json["driver"] =
      known_or_reason(proc_value("/proc/driver/nvidia/version", "NVRM version"), "no NVIDIA driver loaded");
  const CudaSupport& cuda = cuda_support();
  json["runtime"] = known_or_reason(cuda_compiler(), cuda.unusable);
  json["driver_cuda"] = known_or_reason(cuda.driver, cuda.unusable);
  json["device"] = known_or_reason(cuda.device, cuda.unusable);
  json["backend"] =
      choose_backend("auto").backend == Backend::cuda ? "cuda" : fmt::format("cpu: {}", cuda.unusable);
  return json;
}

Json build() {
  const BuildInfo& info = build_info();
  return {{"version", info.version},   {"commit", info.commit},         {"dirty", info.dirty},
          {"compiler", info.compiler}, {"build_type", info.build_type}, {"flags", info.flags},
          {"cuda", info.cuda}};
}

Json libraries() {
  return {{"opencv", CV_VERSION},
          {"tbb", fmt::format("{}.{}", TBB_VERSION_MAJOR, TBB_VERSION_MINOR)},
          {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
          {"nlohmann_json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                        NLOHMANN_JSON_VERSION_PATCH)},
          {"openssl", OpenSSL_version(OPENSSL_VERSION)},
          {"libavformat", known_or_reason(libavformat_version(), "built without it: .mkv cannot be read")}};
}

}  // namespace

std::string environment_json() {
  Json json;
  json["build"] = build();
  json["libraries"] = libraries();
  json["cpu"] = cpu();
  json["gpu"] = gpu();
  utsname system{};
  uname(&system);
  json["system"] = fmt::format("{} {} {}", system.sysname, system.release, system.machine);
  return json.dump(2) + '\n';
}

}  // namespace facet
