#include "dataset/numbered_frames.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "dataset/text_table.hpp"
#include "dataset/timed_list.hpp"

namespace facet {
namespace {

constexpr std::string_view digits = "0123456789";

std::optional<double> last_number(std::string_view id) {
  const std::size_t last = id.find_last_of(digits);
  if (last == std::string_view::npos) return std::nullopt;
  const std::size_t before = id.substr(0, last + 1).find_last_not_of(digits);
  const std::size_t first = before == std::string_view::npos ? 0 : before + 1;
  return finite_number(id.substr(first, last + 1 - first));
}

}  // namespace

NumberedFrames number_frames(const std::vector<std::string>& ids, double rate_hz) {
  std::map<double, std::string> by_number;
  std::size_t without = 0, duplicates = 0;
  for (const std::string& id : ids) {
    const auto number = last_number(id);
    if (!number)
      ++without;
    else
      duplicates += !by_number.emplace(*number, id).second;
  }
  NumberedFrames result;
  for (const auto& [number, id] : by_number) result.frames.push_back({id, number / rate_hz});
  if (without > 0) result.remarks.push_back(entries_text(without) + " left out: no number in the name");
  if (duplicates > 0)
    result.remarks.push_back(entries_text(duplicates) + " left out: another frame has the number");
  if (by_number.empty()) return result;
  const double span = by_number.rbegin()->first - by_number.begin()->first + 1;
  const double absent = span - static_cast<double>(by_number.size());
  if (absent > 0)
    result.remarks.push_back(std::to_string(static_cast<long long>(absent)) + " of " +
                             std::to_string(static_cast<long long>(span)) +
                             " frames absent, by their numbers");
  return result;
}

std::size_t frames_lost(const std::vector<double>& times_s) {
  std::vector<double> distances_s;
  for (std::size_t i = 1; i < times_s.size(); ++i) distances_s.push_back(times_s[i] - times_s[i - 1]);
  if (distances_s.empty()) return 0;
  std::vector<double> sorted = distances_s;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  if (*middle <= 0) return 0;
  double lost = 0;
  for (const double distance_s : distances_s) lost += std::max(0.0, std::round(distance_s / *middle) - 1);
  return static_cast<std::size_t>(std::min(lost, 1e9));
}

}  // namespace facet
