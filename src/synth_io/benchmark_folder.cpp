#include "synth_io/benchmark_folder.hpp"

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "synth_io/checksums.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

std::string version_text() {
  return std::string("generator ") + generator_version + '\n';
}

}  // namespace

std::string benchmark_content(const BenchmarkSpec& spec) {
  return version_text() + spec.text;
}

void open_benchmark_folder(const fs::path& folder, const BenchmarkSpec& spec) {
  std::error_code error;
  const fs::path mark = folder / unfinished_mark;
  if (fs::exists(folder, error) && !(fs::is_directory(folder, error) && fs::is_empty(folder, error))) {
    if (!fs::is_regular_file(mark, error))
      throw Error(ErrorKind::usage, printable(folder) + ": exists and is not an empty folder");
    const std::vector<std::uint8_t> found = read_file_bytes(mark);
    if (std::string(found.begin(), found.end()) != benchmark_content(spec))
      throw Error(ErrorKind::usage,
                  printable(folder) + ": holds the unfinished benchmark of another spec, seed or version");
    return remove_temporary_files(folder);
  }
  fs::create_directories(folder, error);
  if (error)
    throw Error(ErrorKind::internal, printable(folder) + ": folder cannot be made: " + error.message());
  write_file_atomically(mark, benchmark_content(spec));
}

void complete_benchmark_folder(const fs::path& folder, const BenchmarkSpec& spec) {
  write_file_atomically(folder / "version.txt", version_text());
  write_file_atomically(folder / "spec.yaml", spec.text);
  // The sums are those of the folder without the mark. An interruption in between leaves it unfinished.
  write_checksums(folder, unfinished_mark);
  fs::remove(folder / unfinished_mark);
}

void require_finished(const fs::path& folder) {
  std::error_code error;
  fs::path place = fs::absolute(folder, error).lexically_normal();
  for (int level = 0; level < 4; ++level, place = place.parent_path()) {  // BENCHMARK/SET/SEQUENCE/truth
    if (fs::exists(place / unfinished_mark, error))
      throw Error(
          ErrorKind::data,
          printable(place) + ": the benchmark in it is unfinished; the same `facet synth` completes it");
  }
}

}  // namespace facet
