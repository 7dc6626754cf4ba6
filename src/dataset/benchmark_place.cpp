#include "dataset/benchmark_place.hpp"

#include <cstdlib>

#include "core/error.hpp"
#include "dataset/checksum.hpp"
#include "file/file_bytes.hpp"
#include "synth_io/benchmark_folder.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

/// The XDG Base Directory Specification: a value that is no absolute path is ignored.
fs::path default_cache() {
  const auto absolute = [](const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && fs::path(value).is_absolute() ? fs::path(value) : fs::path();
  };
  if (const fs::path cache = absolute("XDG_CACHE_HOME"); !cache.empty()) return cache / "facet";
  if (const fs::path home = absolute("HOME"); !home.empty()) return home / ".cache/facet";
  throw Error(ErrorKind::config,
              "no folder to keep rendered frames in: give the option cache, or set XDG_CACHE_HOME or HOME");
}

std::string content_key(const BenchmarkSpec& spec) {
  const std::string content = benchmark_content(spec);
  return sha256_hex({reinterpret_cast<const std::uint8_t*>(content.data()), content.size()}).substr(0, 32);
}

}  // namespace

bool is_benchmark(const fs::path& root) {
  std::error_code error;
  return fs::is_regular_file(root, error) || fs::is_regular_file(root / unfinished_mark, error) ||
         (fs::is_regular_file(root / "spec.yaml", error) && !fs::exists(root / "dataset.yaml", error));
}

BenchmarkPlace find_benchmark(const fs::path& root, const ReaderOptions& options) {
  if (!is_benchmark(root))
    throw Error(ErrorKind::data, printable(root) +
                                     ": neither the spec of a synthetic benchmark (a YAML file) nor a "
                                     "folder with spec.yaml that was written from one");
  require_finished(root);
  const auto seed = seed_option(options);
  if (fs::is_directory(root)) {
    if (seed)
      throw Error(ErrorKind::config, "option seed: the frames in " + printable(root) + " are written");
    return {read_benchmark_spec(root / "spec.yaml"), root, false};
  }
  BenchmarkPlace place{.spec = read_benchmark_spec(root, seed), .folder = {}, .rendered = true};
  const auto cache = text_option(options, "cache");
  place.folder = (cache ? root.parent_path() / *cache : default_cache()) / "synth" / content_key(place.spec);
  return place;
}

std::vector<BenchmarkPart> benchmark_parts(const BenchmarkSpec& spec) {
  std::vector<BenchmarkPart> parts;
  for (const SetSpec& set : spec.sets) {
    for (PlannedFrame& planned : plan_frames(set)) {
      if (!planned.not_available.empty()) continue;
      const std::string name = set.name + (planned.sequence.empty() ? "" : "/") + planned.sequence;
      if (parts.empty() || parts.back().name != name) parts.push_back({name, set, {}});
      parts.back().frames.push_back(std::move(planned));
    }
  }
  return parts;
}

std::vector<std::string> absent_frames(const SetSpec& set) {
  std::vector<std::string> absent;
  for (const PlannedFrame& planned : plan_frames(set)) {
    if (!planned.not_available.empty()) absent.push_back(planned.id + ": " + planned.not_available);
  }
  return absent;
}

}  // namespace facet
