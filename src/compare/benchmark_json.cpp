#include "compare/benchmark_json.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "score/intervals.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;

struct NamedSamples {
  std::string name;
  std::vector<double> ms;

  double mean() const {
    double sum = 0;
    for (const double v : ms) sum += v;
    return sum / static_cast<double>(ms.size());
  }
  double median() const {
    std::vector<double> sorted = ms;
    std::sort(sorted.begin(), sorted.end());
    return sorted_quantile(sorted, 0.5);
  }
  double deviation() const {
    const double centre = mean();
    double squares = 0;
    for (const double v : ms) squares += (v - centre) * (v - centre);
    return ms.size() < 2 ? 0 : std::sqrt(squares / static_cast<double>(ms.size() - 1));
  }
};

/// Steady samples of every stage and of the total, "method/dataset/stage".
std::vector<NamedSamples> samples_of(const RunRecord& run) {
  std::vector<NamedSamples> out;
  std::map<std::string, std::size_t> place;
  const auto add = [&](const std::string& name, double ms) {
    const auto [found, is_new] = place.try_emplace(name, out.size());
    if (is_new) out.push_back({name, {}});
    out[found->second].ms.push_back(ms);
  };
  for (const TimingSample& sample : run.timing.samples) {
    if (sample.phase != TimingPhase::steady) continue;
    const std::string prefix = sample.method + '/' + sample.dataset + '/';
    for (std::size_t i = 0; i < sample.stage_ms.size(); ++i)
      add(prefix + run.timing.stages[i], sample.stage_ms[i]);
    add(prefix + "total", sample.total_ms);
  }
  if (run.calibration) out.push_back({"calibration", {run.calibration->median_ms}});
  return out;
}

}  // namespace

std::string action_benchmark_json(const RunRecord& run) {
  Json json = Json::array();
  for (const NamedSamples& samples : samples_of(run))
    json.push_back({{"name", samples.name},
                    {"unit", "ms"},
                    {"value", samples.median()},
                    {"range", fmt::format("+- {:.4f}", samples.deviation())},
                    {"extra", fmt::format("median of {} samples", samples.ms.size())}});
  return json.dump(2) + '\n';
}

std::string google_benchmark_json(const RunRecord& run) {
  Json context{
      {"date", run.manifest.started_utc}, {"library_build_type", "release"}, {"build", run.manifest.build}};
  for (const auto& [key, value] : run.environment)
    if (key.starts_with("cpu.") || key == "build.build_type") context[key] = value;
  Json benchmarks = Json::array();
  for (const NamedSamples& samples : samples_of(run)) {
    const auto add = [&](const char* aggregate, double ms) {
      benchmarks.push_back({{"name", fmt::format("{}_{}", samples.name, aggregate)},
                            {"run_name", samples.name},
                            {"run_type", "aggregate"},
                            {"aggregate_name", aggregate},
                            {"iterations", samples.ms.size()},
                            {"real_time", ms},
                            {"cpu_time", ms},
                            {"time_unit", "ms"}});
    };
    add("mean", samples.mean());
    add("median", samples.median());
    add("stddev", samples.deviation());
  }
  return Json{{"context", context}, {"benchmarks", benchmarks}}.dump(2) + '\n';
}

}  // namespace facet
