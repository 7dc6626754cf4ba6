#include "experiment/data_lock.hpp"

#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "dataset/checksum.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

std::string hash_of(const std::string& text) {
  return sha256_hex({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// Depth without row padding, and the camera.
std::string content_hash(const Frame& frame) {
  std::string bytes(sizeof(Camera), '\0');
  std::memcpy(bytes.data(), &frame.camera, sizeof(Camera));
  for (int y = 0; y < frame.depth_m.height(); ++y)
    bytes.append(reinterpret_cast<const char*>(frame.depth_m.row(y)),
                 static_cast<std::size_t>(frame.depth_m.width()) * sizeof(float));
  return hash_of(bytes);
}

bool lies_below(const std::filesystem::path& file, const std::filesystem::path& root) {
  const auto relative = file.lexically_relative(root);
  return !relative.empty() && *relative.begin() != "..";
}

}  // namespace

std::string DataLock::input_hash(const Frame& frame) {
  if (frame.files.empty()) return content_hash(frame);
  std::string all;
  for (const auto& file : frame.files) all += file_hash(file) + '\n';
  return hash_of(all);
}

std::string DataLock::file_hash(const std::filesystem::path& file) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = hashes_.find(file); found != hashes_.end()) return found->second;
  }
  std::string hash = sha256_of_file(file);
  const std::lock_guard lock(mutex_);
  return hashes_.emplace(file, std::move(hash)).first->second;
}

std::string DataLock::to_json(const std::map<std::string, std::filesystem::path>& roots) const {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  const std::lock_guard lock(mutex_);
  for (const auto& [name, root] : roots) {
    auto& dataset = json[name];
    dataset["root"] =
        root.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(printable(root));
    dataset["sha256"] = nlohmann::ordered_json::object();
    for (const auto& [file, hash] : hashes_)
      if (!root.empty() && lies_below(file, root))
        dataset["sha256"][printable(file.lexically_relative(root))] = hash;
  }
  return json.dump(2) + '\n';
}

}  // namespace facet
