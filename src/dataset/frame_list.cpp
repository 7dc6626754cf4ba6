#include "dataset/frame_list.hpp"

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Takes the digits at the start of `s` off it; leading zeros are dropped.
std::string_view take_number(std::string_view& s) {
  std::size_t n = 0;
  while (n < s.size() && is_digit(s[n])) ++n;
  std::string_view digits = s.substr(0, n);
  s.remove_prefix(n);
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  return digits;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view x = take_number(a), y = take_number(b);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
      continue;
    }
    if (a.front() != b.front()) return a.front() < b.front();
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  if (a.empty() != b.empty()) return a.empty();
  return whole_a < whole_b;  // 01 and 1 are different names
}

FramePattern::FramePattern(const std::string& pattern) {
  constexpr std::string_view placeholder = "{id}";
  const std::filesystem::path path(pattern);
  const std::string file = path.filename();
  const std::size_t place = file.find(placeholder);
  if (place == std::string::npos || pattern.find(placeholder) != pattern.rfind(placeholder))
    throw Error(ErrorKind::config, "pattern '" + pattern + "': expected {id} once, in the name of the file");
  folder_ = path.parent_path();
  before_ = file.substr(0, place);
  after_ = file.substr(place + placeholder.size());
}

std::filesystem::path FramePattern::path(const std::filesystem::path& root, std::string_view id) const {
  return root / folder_ / (before_ + std::string(id) + after_);
}

std::vector<std::string> FramePattern::list(const std::filesystem::path& root) const {
  const auto folder = root / folder_;
  std::error_code error;
  std::filesystem::directory_iterator entries(folder, error);
  if (error) throw Error(ErrorKind::data, printable(folder) + ": folder is missing or cannot be read");
  std::vector<std::string> ids;
  for (const auto& entry : entries) {
    const std::string file = entry.path().filename();
    const bool fits =
        file.size() > before_.size() + after_.size() && file.starts_with(before_) && file.ends_with(after_);
    if (fits && escaped_utf8(file) != file)
      throw Error(ErrorKind::data,
                  printable(entry.path()) + ": file name is not UTF-8 (shown with %XX), rename it");
    if (fits) ids.push_back(file.substr(before_.size(), file.size() - before_.size() - after_.size()));
  }
  std::sort(ids.begin(), ids.end(), natural_less);
  return ids;
}

std::vector<std::string> select_frames(const DatasetSpec& spec, const std::vector<std::string>& available) {
  if (available.empty())
    throw Error(ErrorKind::data, printable(spec.root) + ": no frame of data set '" + spec.name + "' is here");
  if (spec.frames.empty()) return available;
  const std::set<std::string> known(available.begin(), available.end());
  std::string absent;
  for (const std::string& id : spec.frames)
    if (!known.contains(id)) absent += (absent.empty() ? "" : ", ") + id;
  if (!absent.empty())
    throw Error(ErrorKind::data,
                printable(spec.root) + ": data set '" + spec.name + "' has no frame " + absent);
  return spec.frames;
}

Image<std::uint16_t> masks_of(const Frame& frame) {
  if (!frame.object_masks) return {};
  const cv::Mat& pixels = *frame.object_masks;
  Image<std::uint16_t> masks(Size{pixels.cols, pixels.rows});
  for (int y = 0; y < pixels.rows; ++y) std::copy_n(pixels.ptr<std::uint16_t>(y), pixels.cols, masks.row(y));
  return masks;
}

ListedDataset::ListedDataset(const DatasetSpec& spec, Sensor sensor, std::vector<std::string> ids)
    : name_(spec.name), sensor_(sensor), ids_(std::move(ids)) {
  if (!spec.annotations.empty()) {
    if (!std::filesystem::is_directory(spec.annotations))
      throw Error(ErrorKind::data, "data set '" + spec.name + "': annotations: " +
                                       printable(spec.annotations) + ": folder is missing");
    annotation_folders_.push_back(spec.annotations);
  }
  if (!spec.root.empty()) annotation_folders_.push_back(spec.root / "truth");
}

std::optional<FrameAnnotation> ListedDataset::annotation(std::size_t index, const Frame& frame) const {
  const Image<std::uint16_t> masks = masks_of(frame);
  std::vector<std::filesystem::path> folders = annotation_folders_;
  if (is_sequence() && !frame.files.empty()) folders.push_back(frame.files.front().parent_path());
  for (const std::filesystem::path& folder : folders)
    if (auto found = read_frame_annotation(folder, frame_id(index), frame.depth_m.size(), masks))
      return found;
  if (masks.empty()) return std::nullopt;
  return FrameAnnotation{std::nullopt, masks, {}, "object masks of the data set"};
}

}  // namespace facet
