#include "experiment/run_directory.hpp"

#include <cerrno>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_write(const fs::path& file) {
  throw Error(ErrorKind::internal,
              fmt::format("{}: cannot be written: {}", printable(file), std::strerror(errno)));
}

std::string directory_suffix(const std::string& config_hash, const std::string& build) {
  return fmt::format("_{}_{}", config_hash.substr(0, 8), build);
}

}  // namespace

RunDirectory::RunDirectory(fs::path path) : path_(std::move(path)) {
  const fs::path file = path_ / ".lock";
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) fail_write(file);
  lock_ = std::shared_ptr<const int>(new int(descriptor), [](const int* held) {
    ::close(*held);
    delete held;
  });
  // The system gives it up with the process, however that ends.
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0)
    throw Error(ErrorKind::internal, fmt::format("{}: another process writes to this run", printable(path_)));
}

LineLog::LineLog(fs::path file) : file_(std::move(file)) {
  descriptor_ = ::open(file_.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail_write(file_);
}

LineLog::~LineLog() {
  ::close(descriptor_);
}

void LineLog::append(std::string_view line) {
  const std::lock_guard lock(mutex_);
  while (!line.empty()) {
    const ssize_t written = ::write(descriptor_, line.data(), line.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_write(file_);
    line.remove_prefix(static_cast<std::size_t>(written));
  }
}

RunDirectory RunDirectory::create(const fs::path& root, const std::string& experiment,
                                  const std::string& config_hash, const std::string& build) {
  const fs::path parent = root / experiment;
  std::error_code failed;
  fs::create_directories(parent, failed);
  if (failed || !fs::is_directory(parent))
    throw Error(ErrorKind::usage, fmt::format("--out {}: the folder {} cannot be made: {}", printable(root),
                                              printable(parent), failed.message()));
  const std::string name = utc_now(true) + directory_suffix(config_hash, build);
  fs::path path = parent / name;
  // Two runs may start within one second.
  for (int i = 2; !fs::create_directory(path, failed); ++i) {
    if (failed)
      throw Error(ErrorKind::usage, fmt::format("--out {}: {} cannot be made: {}", printable(root),
                                                printable(path), failed.message()));
    path = parent / fmt::format("{}_{}", name, i);
  }
  return RunDirectory(path);
}

std::optional<RunDirectory> RunDirectory::find(const fs::path& root, const std::string& experiment,
                                               const std::string& config_hash, const std::string& build) {
  std::error_code absent;
  fs::path newest;
  for (const auto& entry : fs::directory_iterator(root / experiment, absent)) {
    if (entry.is_symlink() || !entry.is_directory()) continue;
    const std::string name = entry.path().filename().string();
    const std::string suffix = directory_suffix(config_hash, build);
    const std::size_t found = name.find(suffix);
    const bool matches = found != std::string::npos &&
                         (found + suffix.size() == name.size() || name[found + suffix.size()] == '_');
    if (matches && entry.path() > newest) newest = entry.path();
  }
  if (newest.empty()) return std::nullopt;
  return RunDirectory(newest);
}

void RunDirectory::publish(const fs::path& relative, std::string_view text) const {
  write_file_atomically(path_ / relative, text);
}

void RunDirectory::become_latest() const {
  const fs::path link = path_.parent_path() / "latest";
  const fs::path fresh = path_.parent_path() / fmt::format(".latest.{}", ::getpid());
  std::error_code failed;
  fs::remove(fresh, failed);
  fs::create_directory_symlink(path_.filename(), fresh, failed);
  if (!failed) fs::rename(fresh, link, failed);
  if (failed)
    throw Error(ErrorKind::internal,
                fmt::format("{}: cannot be written: {}", printable(link), failed.message()));
}

std::string utc_now(bool compact) {
  const std::time_t now = std::time(nullptr);
  const std::tm utc = fmt::gmtime(now);
  return compact ? fmt::format("{:%Y%m%dT%H%M%SZ}", utc) : fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", utc);
}

}  // namespace facet
