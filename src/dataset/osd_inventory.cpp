#include "dataset/osd_inventory.hpp"

#include <nlohmann/json.hpp>

#include "dataset/checksum.hpp"
#include "dataset/osd_manifest.hpp"
#include "dataset/verify.hpp"

namespace facet {
namespace {

FrameGroup find_group(const nlohmann::json& range, const std::filesystem::path& root) {
  FrameGroup group{.name = range.at("prefix").get<std::string>()};
  for (int i = range.at("first").get<int>(); i <= range.at("last").get<int>(); ++i) {
    const std::string id = group.name + std::to_string(i);
    const bool found = std::filesystem::exists(root / "disparity" / (id + ".png")) &&
                       std::filesystem::exists(root / "image_color" / (id + ".png"));
    ++group.expected;
    if (!found) group.absent.push_back(id);
  }
  return group;
}

void compare_checksum(const nlohmann::json& known, const std::string& source,
                      const std::filesystem::path& root, DatasetReport& report) {
  const std::string file = known.at("file");
  if (!std::filesystem::is_regular_file(root / file) || std::filesystem::file_size(root / file) == 0) return;
  ++report.checksums_compared;
  if (sha256_of_file(root / file) == known.at("sha256").get<std::string>()) return;
  report.problems.push_back({file, "its checksum is not that of the copy at " + source});
}

void note_point_clouds(const std::filesystem::path& root, DatasetReport& report) {
  if (!std::filesystem::is_directory(root / "pcd")) return;
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(root / "pcd"))
    count += entry.is_regular_file();
  report.notes.push_back("pcd/ has " + std::to_string(count) + " files, which are not read");
}

}  // namespace

void inspect_osd(const DatasetSpec& spec, DatasetReport& report) {
  const auto manifest = nlohmann::json::parse(osd_manifest_json);
  for (const auto& range : manifest.at("frames")) report.groups.push_back(find_group(range, spec.root));
  for (const auto& known : manifest.at("files"))
    compare_checksum(known, manifest.at("sources").at(known.at("source").get<std::string>()), spec.root,
                     report);
  note_point_clouds(spec.root, report);
}

}  // namespace facet
