#include "dataset/timed_list.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace facet {
namespace {

struct Pair {
  double apart_s;
  std::size_t a, b;
};

std::vector<Pair> pairs_within(const std::vector<TimedFile>& a, const std::vector<TimedFile>& b,
                               double tolerance_s) {
  std::vector<Pair> pairs;
  std::size_t first = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    while (first < b.size() && b[first].timestamp_s < a[i].timestamp_s - tolerance_s) ++first;
    for (std::size_t k = first; k < b.size() && b[k].timestamp_s <= a[i].timestamp_s + tolerance_s; ++k)
      pairs.push_back({std::abs(a[i].timestamp_s - b[k].timestamp_s), i, k});
  }
  return pairs;
}

}  // namespace

std::string entries_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " entry" : " entries");
}

std::vector<std::string> TimedList::remarks(const std::string& name) const {
  std::vector<std::string> texts;
  const auto remark = [&](std::size_t count, const char* what) {
    if (count > 0) texts.push_back(entries_text(count) + " of " + name + ' ' + what);
  };
  remark(broken_lines, "left out: not a time and a file");
  remark(missing, "left out: the file is missing");
  remark(duplicates, "left out: the time or the file stands there before");
  remark(out_of_order, "out of order, put in order");
  return texts;
}

TimedList timed_list(const std::vector<TextLine>& lines, const std::filesystem::path& root) {
  TimedList list;
  std::set<double> times;
  std::set<std::string> names;
  double latest_s = -HUGE_VAL;
  for (const TextLine& line : lines) {
    const auto timestamp_s = line.size() == 2 ? finite_number(line[0]) : std::nullopt;
    if (!timestamp_s) {
      ++list.broken_lines;
      continue;
    }
    const std::filesystem::path file = root / line[1];
    std::error_code error;
    if (times.contains(*timestamp_s) || names.contains(file.stem())) {
      ++list.duplicates;
    } else if (!std::filesystem::is_regular_file(file, error)) {
      ++list.missing;
    } else {
      list.out_of_order += *timestamp_s < latest_s;
      latest_s = std::max(latest_s, *timestamp_s);
      times.insert(*timestamp_s);
      names.insert(file.stem());
      list.files.push_back({*timestamp_s, file});
    }
  }
  std::sort(list.files.begin(), list.files.end(),
            [](const TimedFile& a, const TimedFile& b) { return a.timestamp_s < b.timestamp_s; });
  return list;
}

std::vector<std::optional<std::size_t>> associate(const std::vector<TimedFile>& a,
                                                  const std::vector<TimedFile>& b, double tolerance_s) {
  std::vector<Pair> pairs = pairs_within(a, b, tolerance_s);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& p, const Pair& q) { return p.apart_s < q.apart_s; });
  std::vector<std::optional<std::size_t>> partner(a.size());
  std::vector<bool> taken(b.size());
  for (const Pair& pair : pairs) {
    if (partner[pair.a] || taken[pair.b]) continue;
    partner[pair.a] = pair.b;
    taken[pair.b] = true;
  }
  return partner;
}

}  // namespace facet
