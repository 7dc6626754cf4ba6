#include "gpu_report.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "stage_traffic.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;

/// Beside n, which says why a quantile is not there.
Json quantiles(const Times& times) {
  Json json{{"n", times.count()}, {"p50", times.median()}, {"p90", nullptr}, {"p99", nullptr}};
  if (const auto p90 = times.quantile(0.9)) json["p90"] = *p90;
  if (const auto p99 = times.quantile(0.99)) json["p99"] = *p99;
  return json;
}
std::string text_of(const std::optional<double>& ms) {
  return ms ? fmt::format("{:.3f}", *ms) : "n/a";
}

int bytes_per_px(StageId id) {
  for (const StageTraffic& row : stage_traffic())
    if (row.id == id) return std::max(row.bytes_per_px.at("default"), 0);
  return 0;
}

/// What a stage costs on any device with these rates: its launches, or its bytes, whichever take longer.
struct StageFloor {
  double launches_ms, bytes_ms;
  double ms() const { return std::max(launches_ms, bytes_ms); }
};
StageFloor floor_of(const CudaFloor& floor, int work, StageId id, Size size) {
  return {work * floor.launch_us / 1000,
          bytes_per_px(id) * static_cast<double>(size.area()) / floor.copy_bytes_per_s * 1000};
}

Json stages_json(const GpuReport& report, const SizeReport& size) {
  Json rows = Json::array();
  for (const StageName& stage : stage_names) {
    const auto i = static_cast<std::size_t>(index_of(stage.id));
    Json row{{"stage", std::string(stage.key)}, {"ms", quantiles(size.latency.stages[i])}};
    row["bytes_per_px"] = bytes_per_px(stage.id);
    row["cpu_ms_p50"] = size.cpu.stages[i].median();
    if (report.floor && size.work) {
      const StageFloor floor = floor_of(*report.floor, (*size.work)[i], stage.id, size.size);
      row["launches"] = (*size.work)[i];
      row["floor_launches_ms"] = floor.launches_ms;
      row["floor_bytes_ms"] = floor.bytes_ms;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Json throughput_json(const Throughput& t) {
  return {{"in_flight", t.in_flight},
          {"frames", t.frames},
          {"frames_per_s", t.frames_per_s()},
          {"latency_ms", quantiles(t.latency)}};
}

std::string size_name(Size size) {
  return fmt::format("{}x{}", size.width, size.height);
}

void write_stage_table(std::string& text, const GpuReport& report, const SizeReport& size) {
  text += fmt::format("\n## {}\n\n| stage | median [ms] | CPU, one thread [ms] |", size_name(size.size));
  text += " launches | floor of launches [ms] | floor of bytes [ms] | times its floor |\n";
  text += "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const StageName& stage : stage_names) {
    const auto i = static_cast<std::size_t>(index_of(stage.id));
    const double ms = size.latency.stages[i].median();
    text += fmt::format("| {} | {:.4f} | {:.4f} |", stage.key, ms, size.cpu.stages[i].median());
    if (!report.floor || !size.work) {
      text += " n/a | n/a | n/a | n/a |\n";
      continue;
    }
    const StageFloor floor = floor_of(*report.floor, (*size.work)[i], stage.id, size.size);
    const std::string ratio =
        floor.ms() > 0 && (*size.work)[i] > 0 ? fmt::format("{:.1f}", ms / floor.ms()) : "host";
    text += fmt::format(" {} | {:.4f} | {:.4f} | {} |\n", (*size.work)[i], floor.launches_ms, floor.bytes_ms,
                        ratio);
  }
}

void write_latencies(std::string& text, const GpuReport& report) {
  text +=
      "\n## Latency\n\nFrom decoded depth in host memory to contours, poses, grasps and labels in host "
      "memory;";
  text +=
      " default parameters.\n\n| size | p50 [ms] | p90 | p99 | n | first frame | CPU, one thread | side by "
      "side |\n";
  text += "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const SizeReport& size : report.sizes) {
    const Times& t = size.latency.total;
    text += fmt::format(
        "| {} | {:.3f} | {} | {} | {} | {:.1f} | {:.3f} | {} in flight: {:.0f} frames/s, p50 {:.3f} "
        "ms |\n",
        size_name(size.size), t.median(), text_of(t.quantile(0.9)), text_of(t.quantile(0.99)), t.count(),
        size.latency.first_ms, size.cpu.total.median(), size.side_by_side.in_flight,
        size.side_by_side.frames_per_s(), size.side_by_side.latency.median());
  }
  text += fmt::format(
      "\nBatch: {} frames, {} in flight: {:.0f} frames/s. Decoding on one thread: {:.0f} frames/s.\n",
      report.batch.frames, report.batch.in_flight, report.batch.frames_per_s(), report.decoded_per_s);
}

}  // namespace

std::string to_json(const GpuReport& report) {
  Json json{{"schema_version", 1}};
  for (const auto& [key, value] : report.facts) json["facts"][key] = value;
  json["floor"] = nullptr;
  if (const auto& f = report.floor)
    json["floor"] = {{"copy_bytes_per_s", f->copy_bytes_per_s},
                     {"upload_bytes_per_s", f->upload_bytes_per_s},
                     {"download_bytes_per_s", f->download_bytes_per_s},
                     {"launch_us", f->launch_us},
                     {"round_trip_us", f->round_trip_us}};
  json["parity"] = {{"frames", report.compared_frames}, {"differing", report.differing}};
  json["repeats"] = {{"runs", report.runs}, {"distinct_results", report.distinct}};
  for (const SizeReport& size : report.sizes)
    json["sizes"].push_back({{"size", size_name(size.size)},
                             {"frames", size.scenes_frames},
                             {"total_ms", quantiles(size.latency.total)},
                             {"first_ms", size.latency.first_ms},
                             {"cpu_total_ms", quantiles(size.cpu.total)},
                             {"side_by_side", throughput_json(size.side_by_side)},
                             {"stages", stages_json(report, size)}});
  json["batch"] = throughput_json(report.batch);
  json["decoded_frames_per_s"] = report.decoded_per_s;
  return json.dump(1) + '\n';
}

std::string to_markdown(const GpuReport& report) {
  std::string text = "# GPU check\n\n| | |\n| --- | --- |\n";
  for (const auto& [key, value] : report.facts) text += fmt::format("| {} | {} |\n", key, value);
  text += fmt::format("| frames compared with the CPU | {}, {} differ |\n", report.compared_frames,
                      report.differing.size());
  text += fmt::format("| runs over one frame | {}, {} distinct result{} |\n", report.runs, report.distinct,
                      report.distinct == 1 ? "" : "s");
  if (const auto& f = report.floor) {
    text += fmt::format("| copies within the device, read and written | {:.0f} GB/s |\n",
                        f->copy_bytes_per_s / 1e9);
    text += fmt::format("| upload, download, pinned | {:.1f}, {:.1f} GB/s |\n", f->upload_bytes_per_s / 1e9,
                        f->download_bytes_per_s / 1e9);
    text += fmt::format("| launch of a kernel, and waiting for one | {:.2f}, {:.2f} us |\n", f->launch_us,
                        f->round_trip_us);
  }
  write_latencies(text, report);
  for (const SizeReport& size : report.sizes) write_stage_table(text, report, size);
  text +=
      "\nA stage cannot be faster than its launches (kernels and copies, as counted) or than its bytes at "
      "the";
  text += " rate of a copy, whichever is larger. `host`: it gives the device nothing to do.\n";
  return text;
}

}  // namespace facet
