#include "record/gallery.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "core/error.hpp"
#include "score/metrics.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;
using Key = std::tuple<std::string, std::string, std::string>;

const Metric& metric_called(const std::string& name) {
  std::string names;
  for (const Metric& metric : score_metrics()) {
    if (metric.name == name) return metric;
    names += (names.empty() ? "" : ", ") + metric.name;
  }
  throw Error(ErrorKind::usage, "no metric is called '" + name + "'; there are " + names);
}

std::optional<double> value_in(const FrameRow& row, const Metric& metric) {
  if (!row.score || !metric.is_annotated(*row.score)) return std::nullopt;
  if (!row.score->failed && !metric.is_predicted(*row.score)) return std::nullopt;
  return metric.value(metric.sums(*row.score));
}

/// Keeps the `count` entries of every data set and method with the lowest merit.
std::vector<GalleryEntry> lowest(std::vector<GalleryEntry> entries, std::size_t count,
                                 const std::function<double(const GalleryEntry&)>& merit) {
  std::stable_sort(entries.begin(), entries.end(), [&](const GalleryEntry& a, const GalleryEntry& b) {
    return std::forward_as_tuple(a.dataset, a.method, merit(a)) <
           std::forward_as_tuple(b.dataset, b.method, merit(b));
  });
  std::map<std::pair<std::string, std::string>, std::size_t> kept;
  std::erase_if(entries, [&](const GalleryEntry& e) { return ++kept[{e.dataset, e.method}] > count; });
  return entries;
}

std::vector<GalleryEntry> rated(const std::vector<FrameRow>& rows, const Metric& metric) {
  std::vector<GalleryEntry> entries;
  for (const FrameRow& row : rows)
    if (const std::optional<double> value = value_in(row, metric))
      entries.push_back({row.dataset,
                         row.frame,
                         row.method,
                         metric.name,
                         value,
                         {},
                         row.pictures.empty() ? "" : row.pictures.front()});
  return entries;
}

template <class Entry, class Visitor>
void visit_entry(Entry& e, Visitor&& visit) {
  visit("dataset", e.dataset);
  visit("frame", e.frame);
  visit("method", e.method);
  visit("metric", e.metric);
  visit("picture", e.picture);
}

std::optional<double> number_or_null(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

}  // namespace

std::vector<GalleryEntry> worst_frames(const std::vector<FrameRow>& rows, const std::string& name,
                                       std::size_t count) {
  const Metric& metric = metric_called(name);
  const double sign = metric.less_is_better ? -1 : 1;
  return lowest(rated(rows, metric), count, [sign](const GalleryEntry& e) { return sign * *e.value; });
}

std::vector<GalleryEntry> worst_frames(const std::vector<FrameRow>& rows,
                                       const std::vector<FrameRow>& baseline, const std::string& name,
                                       std::size_t count) {
  const Metric& metric = metric_called(name);
  std::map<Key, double> before;
  for (const GalleryEntry& e : rated(baseline, metric)) before[{e.dataset, e.frame, e.method}] = *e.value;
  std::vector<GalleryEntry> entries = rated(rows, metric);
  std::erase_if(entries, [&](GalleryEntry& e) {
    const auto found = before.find({e.dataset, e.frame, e.method});
    if (found == before.end()) return true;
    e.baseline = found->second;
    return false;
  });
  const double sign = metric.less_is_better ? -1 : 1;
  return lowest(std::move(entries), count,
                [sign](const GalleryEntry& e) { return sign * (*e.value - *e.baseline); });
}

std::vector<GalleryEntry> disputed_frames(const std::vector<FrameRow>& rows, const std::string& name,
                                          std::size_t count) {
  const Metric& metric = metric_called(name);
  const double sign = metric.less_is_better ? -1 : 1;
  std::map<std::pair<std::string, std::string>, GalleryEntry> frames;
  for (const GalleryEntry& e : rated(rows, metric)) {
    const auto [found, is_first] = frames.try_emplace({e.dataset, e.frame}, e);
    GalleryEntry& entry = found->second;
    if (is_first) entry.baseline = e.value;
    entry.picture.clear();
    if (sign * *e.value > sign * *entry.value) entry.value = e.value, entry.method = e.method;
    if (sign * *e.value < sign * *entry.baseline) entry.baseline = e.value;
  }
  std::vector<GalleryEntry> entries;
  for (const auto& [key, entry] : frames)
    if (*entry.value != *entry.baseline) entries.push_back(entry);
  const auto spread = [sign](const GalleryEntry& e) { return sign * (*e.value - *e.baseline); };
  std::stable_sort(entries.begin(), entries.end(), [&](const GalleryEntry& a, const GalleryEntry& b) {
    return a.dataset != b.dataset ? a.dataset < b.dataset : spread(a) > spread(b);
  });
  std::map<std::string, std::size_t> kept;
  std::erase_if(entries, [&](const GalleryEntry& e) { return ++kept[e.dataset] > count; });
  return entries;
}

std::string to_json(const std::vector<GalleryEntry>& entries) {
  Json list = Json::array();
  for (const GalleryEntry& e : entries) {
    Json json;
    visit_entry(e, [&](const char* key, const std::string& value) { json[key] = value; });
    json["value"] = e.value ? Json(*e.value) : Json(nullptr);
    json["baseline"] = e.baseline ? Json(*e.baseline) : Json(nullptr);
    list.push_back(std::move(json));
  }
  return Json{{"schema_version", 1}, {"frames", list}}.dump(1) + '\n';
}

std::vector<GalleryEntry> gallery_from_json(std::string_view text) {
  std::vector<GalleryEntry> entries;
  try {
    const Json file = Json::parse(text);
    for (const Json& json : file.at("frames")) {
      GalleryEntry& e = entries.emplace_back();
      visit_entry(e, [&](const char* key, std::string& value) { json.at(key).get_to(value); });
      e.value = number_or_null(json.at("value"));
      e.baseline = number_or_null(json.at("baseline"));
    }
  } catch (const nlohmann::json::exception& e) {
    throw Error(ErrorKind::data, std::string("no gallery: ") + e.what());
  }
  return entries;
}

}  // namespace facet
