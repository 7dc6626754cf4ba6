#include <fmt/format.h>

#include "record/csv.hpp"
#include "record/optional_json.hpp"
#include "stream/stream_report.hpp"
#include "stream/stream_summary.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;

Json times_json(const StreamTimes& times) {
  const TimeStatistics& t = times.wall;
  Json json{{"name", times.name}, {"frames", t.n}};
  if (times.threads > 0) json["threads"] = times.threads;
  if (t.n == 0) {
    json["reason"] = "no frame after warm-up";
    return json;
  }
  json["mean_ms"] = t.mean_ms;
  json["sd_ms"] = t.deviation_ms;
  for (std::size_t i = 0; i < percentiles.size(); ++i) {
    json[fmt::format("p{}_ms", percentiles[i])] = t.percentile_ms[i];
    if (!t.percentile_ms[i])
      json[fmt::format("p{}_reason", percentiles[i])] =
          fmt::format("n = {} < {}", t.n, least_samples_for(percentiles[i]));
  }
  json["max_ms"] = t.max_ms;
  for (std::size_t i = 0; i < deadlines_ms.size(); ++i)
    json[fmt::format("over_{:.1f}_ms", deadlines_ms[i])] = t.deadline_misses[i];
  if (times.threads > 0) json["cpu_mean_ms"] = times.cpu_mean_ms;
  return json;
}

Json all_times_json(const std::vector<StreamTimes>& list) {
  Json json = Json::array();
  for (const StreamTimes& times : list) json.push_back(times_json(times));
  return json;
}

Json queues_json(const StreamRecord& record) {
  Json json = Json::array();
  for (const QueueStatistics& q : record.queues)
    json.push_back({{"room", q.capacity},
                    {"mean_depth", q.mean_depth},
                    {"max_depth", q.max_depth},
                    {"taken_in", q.taken_in},
                    {"dropped", q.dropped}});
  return json;
}

Json record_json(const StreamRecord& r) {
  const StreamSummary summary = summarize(r);
  Json json{{"dataset", r.dataset},
            {"method", r.method},
            {"interrupted", r.interrupted},
            {"due", r.due},
            {"offered", r.offered},
            {"processed", r.samples.size()},
            {"dropped", r.dropped()},
            {"accepted_late", r.late},
            {"warmup", r.options.warmup},
            {"frames_in_memory", r.frames_in_memory},
            {"threads_in_frame", r.threads_in_frame},
            {"throughput_hz", summary.throughput_hz},
            {"sustained", summary.is_sustained}};
  if (!summary.is_sustained) json["sustained_reason"] = "no rate was asked for";
  json["filters"] = all_times_json(summary.filters);
  json["pass"] = times_json(summary.pass);
  json["end_to_end"] = times_json(summary.latency);
  json["stages"] = all_times_json(summary.stages);
  json["queues"] = queues_json(r);
  json["memory_mb"] = {
      {"after_warmup", r.memory.after_warmup_mb}, {"max", r.memory.max_mb}, {"end", r.memory.end_mb}};
  json["cpu_per_frame_ms"] = summary.cpu_per_frame_ms;
  json["most_hz_by_cpu"] = summary.most_hz;
  if (!summary.most_hz)
    json["cpu_reason"] =
        r.threads_in_frame > 1 ? "several threads work inside a frame" : "no frame after warm-up";
  json["cores"] = {{"usable", r.load.cores}, {"own", r.load.own_cores}, {"others", r.load.other_cores}};
  return json;
}

}  // namespace

std::string stream_json(const std::vector<StreamRecord>& records) {
  Json json = Json::array();
  for (const StreamRecord& record : records) json.push_back(record_json(record));
  return json.dump(2) + '\n';
}

std::string stream_csv(const std::vector<StreamRecord>& records) {
  CsvRow header{"dataset", "method", "frame", "done_s", "end_to_end_ms", "pass_ms", "surfaces"};
  std::size_t filters = 0;
  for (const StreamRecord& r : records) filters = std::max(filters, r.options.filters.size());
  for (std::size_t i = 0; i < filters; ++i)
    header.insert(header.end(), {fmt::format("filter{}_ms", i + 1), fmt::format("filter{}_cpu_ms", i + 1)});
  std::string text = csv_line(header);
  for (const StreamRecord& r : records)
    for (const StreamSample& s : r.samples) {
      CsvRow row{r.dataset, r.method, std::to_string(s.number), fmt::format("{:.4f}", s.done_s)};
      for (const double ms : {s.latency_ms, s.pass_ms}) row.push_back(fmt::format("{:.4f}", ms));
      row.push_back(std::to_string(s.surfaces));
      for (std::size_t i = 0; i < filters; ++i)
        for (const double ms : {s.filters[i].work_ms, s.filters[i].cpu_ms})
          row.push_back(fmt::format("{:.4f}", ms));
      text += csv_line(row);
    }
  return text;
}

}  // namespace facet
