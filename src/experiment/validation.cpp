#include "experiment/validation.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"
#include "dataset/benchmark_place.hpp"
#include "experiment/data_root.hpp"
#include "experiment/dataset_text.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

fs::path named_folder(const std::string& name, const std::optional<std::string>& data_root) {
  const fs::path root = locate(dataset_called(name), data_root).root;
  if (fs::is_directory(root)) return root;
  throw Error(ErrorKind::data,
              printable(root.empty() ? fs::path(name) : root) + ": is no folder of annotations");
}

}  // namespace

ValidationReport validate_named(const std::string& dataset_or_folder,
                                const std::optional<std::string>& data_root,
                                const std::optional<std::string>& mask_folder) {
  const fs::path root = named_folder(dataset_or_folder, find_data_root(data_root));
  if (mask_folder && !fs::is_directory(*mask_folder))
    throw Error(ErrorKind::data, *mask_folder + ": folder is missing");
  if (is_benchmark(root) && !mask_folder) return validate_benchmark(root);
  const fs::path annotations = fs::is_directory(root / "truth") ? root / "truth" : root;
  const fs::path masks = fs::is_directory(root / "annotation") ? root / "annotation" : fs::path();
  return validate_annotations(annotations, mask_folder ? fs::path(*mask_folder) : masks);
}

std::string describe_validation(const ValidationReport& report) {
  std::string text;
  for (const std::string& problem : report.problems) text += problem + '\n';
  return text + fmt::format("{} annotations, {} problems\n", report.frames, report.problems.size());
}

}  // namespace facet
