#include "file/file_bytes.hpp"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <unistd.h>

#include "core/error.hpp"
#include "file/publish_file.hpp"

namespace facet {
namespace {

/// Length of the UTF-8 sequence at the start of `s`, 0 where there is none (RFC 3629).
std::size_t utf8_length(std::string_view s) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
  const unsigned lead = byte(0);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  if (length > s.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
  const bool surrogate = lead == 0xED && byte(1) > 0x9F;
  const bool beyond = lead == 0xF4 && byte(1) > 0x8F;
  return overlong || surrogate || beyond ? 0 : length;
}

[[noreturn]] void fail_writing(const std::filesystem::path& path) {
  throw Error(ErrorKind::internal, printable(path) + ": cannot be written: " + std::strerror(errno));
}

void write_all(int descriptor, std::span<const std::uint8_t> bytes, const std::filesystem::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_writing(path);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

constexpr const char* temporary_suffix = ".tmp-";

/// A temporary file that vanishes unless it was published.
class TemporaryFile {
 public:
  /// Its name ends in `extension`, for libraries that go by that.
  explicit TemporaryFile(const std::filesystem::path& target, const std::string& extension = {})
      : target_(target), path_(target) {
    static std::atomic<unsigned> counter = 0;
    path_ += temporary_suffix + std::to_string(::getpid()) + "-" + std::to_string(counter++) + extension;
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (descriptor_ < 0) fail_writing(path_);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  const std::filesystem::path& path() const { return path_; }
  void write(std::span<const std::uint8_t> bytes) { write_all(descriptor_, bytes, target_); }
  void publish() {
    const int closed = ::close(descriptor_);  // a full disk may show only here
    descriptor_ = -1;
    if (closed != 0 || ::rename(path_.c_str(), target_.c_str()) != 0) fail_writing(target_);
    path_.clear();
  }

 private:
  std::filesystem::path target_, path_;
  int descriptor_ = -1;
};

void make_folder_of(const std::filesystem::path& path) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  if (error)
    throw Error(ErrorKind::internal,
                printable(path.parent_path()) + ": folder cannot be made: " + error.message());
}

}  // namespace

std::string escaped_utf8(std::string_view bytes) {
  std::string text;
  while (!bytes.empty()) {
    if (const std::size_t length = utf8_length(bytes); length > 0) {
      text.append(bytes.substr(0, length));
      bytes.remove_prefix(length);
      continue;
    }
    constexpr std::string_view digits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(bytes.front());
    text.append({'%', digits[byte >> 4], digits[byte & 15]});
    bytes.remove_prefix(1);
  }
  return text;
}

std::string printable(const std::filesystem::path& path) {
  return escaped_utf8(path.native());
}

std::vector<std::uint8_t> read_file_bytes(const std::filesystem::path& path) {
  const auto fail = [&](const std::string& rule) {
    throw Error(ErrorKind::data, printable(path) + ": " + rule);
  };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) fail("file is missing");
  if (!std::filesystem::is_regular_file(status)) fail("is not a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail("file cannot be opened for reading");
  std::vector<std::uint8_t> bytes(std::filesystem::file_size(path, error));
  if (error) fail("file cannot be read");
  if (bytes.empty()) fail("file is empty");
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (in.gcount() != static_cast<std::streamsize>(bytes.size())) fail("file cannot be read to its end");
  return bytes;
}

void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  make_folder_of(path);
  TemporaryFile file(path);
  file.write(bytes);
  file.publish();
}

void publish_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path& place)>& write) {
  make_folder_of(path);
  TemporaryFile file(path, path.extension().string());
  write(file.path());
  file.publish();
}

void write_file_atomically(const std::filesystem::path& path, std::string_view text) {
  write_file_atomically(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void remove_temporary_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const bool temporary = entry.path().filename().native().find(temporary_suffix) != std::string::npos;
    if (temporary && entry.is_regular_file()) found.push_back(entry.path());
  }
  for (const auto& file : found) std::filesystem::remove(file);
}

}  // namespace facet
