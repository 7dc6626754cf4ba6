// Checks the CUDA back end on this machine and measures it: results against the CPU's, repeats, the time of
// every stage beside what the device could do at best, latency and throughput. Needs no data sets, no
// configs and of OpenCV the core and imgproc alone, so that it travels (scripts/bundle.sh).
//
//   facet_gpu_check --device               names the device
//   facet_gpu_check --make-frames DIR      writes the raw frames that it measures with
//   facet_gpu_check --frames DIR --json FILE --markdown FILE
//
// Exit codes as those of facet: 0 all measured and equal, 1 results differ, 2 usage, 4 frames missing or
// broken, 6 no device, 70 a fault of its own.
#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fstream>
#include <map>
#include <thread>

#include "core/error.hpp"
#include "cpu/cpu_pipeline.hpp"
#include "cuda/cuda_pipeline.hpp"
#include "exit_code.hpp"
#include "gpu_report.hpp"

namespace facet {
namespace {

constexpr std::uint64_t seed = 1;

struct Arguments {
  std::string frames = "frames", make_frames, json, markdown, backend = "cuda";
  bool device = false;
  std::vector<std::string> facts;
  int warmup = 20, repeats = 1000, in_flight = 8, batch_frames = 10000, threads = 1;
};

int make_frames(const std::string& folder) {
  std::vector<RawFrame> frames;
  for (const auto& [size, count] : {std::pair{Size{640, 480}, 64}, {Size{640, 576}, 8}, {Size{1280, 720}, 8}})
    for (RawFrame& frame : render_raw_frames(size, count)) frames.push_back(std::move(frame));
  write_raw_frames(folder, frames);
  fmt::print("{}: {} frames\n", folder, frames.size());
  return 0;
}

int name_device() {
  const CudaSupport cuda = find_cuda_support();
  if (!cuda.unusable.empty()) throw Error(ErrorKind::not_measured, cuda.unusable);
  fmt::print("{}\n", cuda.device);
  return 0;
}

/// Frames by size, smallest first.
std::vector<std::vector<RawFrame>> by_size(std::vector<RawFrame> frames) {
  std::map<std::pair<std::ptrdiff_t, int>, std::vector<RawFrame>> groups;
  for (RawFrame& frame : frames)
    groups[{frame.depth.size().area(), frame.depth.width()}].push_back(std::move(frame));
  std::vector<std::vector<RawFrame>> sorted;
  for (auto& [key, group] : groups) sorted.push_back(std::move(group));
  return sorted;
}

class GpuCheck {
 public:
  explicit GpuCheck(const Arguments& arguments) : a_(arguments) {
    const CudaSupport cuda = find_cuda_support();
    if (on_device() && !cuda.unusable.empty()) throw Error(ErrorKind::not_measured, cuda.unusable);
    fact("back end", a_.backend);
    fact("device", on_device() ? cuda.device : "none: the CPU was measured");
    fact("driver serves CUDA", cuda.driver.empty() ? "no driver" : cuda.driver);
    fact("built with CUDA", cuda_compiler().empty() ? "no" : cuda_compiler());
    fact("CPU threads", std::to_string(std::thread::hardware_concurrency()));
    fact("threads on the host inside a single frame", std::to_string(a_.threads));
    for (const std::string& text : a_.facts) {
      const std::size_t sign = text.find('=');
      fact(text.substr(0, sign), sign == std::string::npos ? "yes" : text.substr(sign + 1));
    }
  }

  GpuReport run(std::vector<RawFrame> frames) {
    if (on_device()) report_.floor = measure_cuda_floor();
    compare(frames);
    for (const std::vector<RawFrame>& group : by_size(std::move(frames))) measure(group);
    return std::move(report_);
  }

 private:
  bool on_device() const { return a_.backend == "cuda"; }
  void fact(const std::string& key, const std::string& text) { report_.facts.emplace_back(key, text); }
  std::unique_ptr<Pipeline> make(int threads = 1) const {
    if (!on_device()) return make_cpu_pipeline({}, seed, threads);
    return std::move(
        make_cuda_pipelines(1, {}, seed, [threads] { return make_host_threads(threads); }).front());
  }

  void compare(const std::vector<RawFrame>& frames) {
    const auto cpu = make_cpu_pipeline({}, seed), measured = make();
    report_.compared_frames = static_cast<int>(frames.size());
    report_.differing = differing_frames(*cpu, *measured, frames);
    report_.runs = 20;
    report_.distinct = distinct_results(*measured, frames.front(), report_.runs);
  }

  void measure(const std::vector<RawFrame>& frames) {
    SizeReport size{frames.front().depth.size(),
                    static_cast<int>(frames.size()),
                    measure_latency(*make(a_.threads), frames, a_.warmup, a_.repeats),
                    measure_throughput([this] { return make(); }, frames, a_.in_flight, 2 * a_.repeats),
                    measure_latency(*make_cpu_pipeline({}, seed), frames, 1, std::max(1, a_.repeats / 10)),
                    {}};
    if (on_device()) {
      Image<float> depth_m;
      decode(frames.front(), depth_m);
      size.work = count_cuda_work({}, input_of(frames.front(), depth_m));
    }
    report_.sizes.push_back(std::move(size));
    // The batch is measured on the size with the most frames.
    if (frames.size() <= batch_of_) return;
    batch_of_ = frames.size();
    report_.decoded_per_s = decode_rate(frames);
    report_.batch = measure_throughput([this] { return make(); }, frames, a_.in_flight, a_.batch_frames);
  }

  const Arguments& a_;
  GpuReport report_;
  std::size_t batch_of_ = 0;
};

void write(const std::string& file, const std::string& text) {
  if (file.empty()) return;
  std::ofstream output(file);
  output << text;
  if (!output.flush()) throw Error(ErrorKind::internal, file + ": cannot be written");
}

int check(const Arguments& a) {
  GpuCheck gpu_check(a);
  const GpuReport report = gpu_check.run(read_raw_frames(a.frames));
  write(a.json, to_json(report));
  write(a.markdown, to_markdown(report));
  fmt::print("{}", to_markdown(report));
  return report.differing.empty() && report.distinct == 1 ? 0 : 1;
}

}  // namespace
}  // namespace facet

int main(int argc, char** argv) {
  facet::Arguments a;
  CLI::App app("Checks the CUDA back end on this machine and measures it.");
  auto* frames = app.add_option("--frames", a.frames, "folder of raw frames")->capture_default_str();
  app.add_option("--make-frames", a.make_frames, "write a folder of raw frames and stop")->excludes(frames);
  app.add_flag("--device", a.device, "name the device and stop");
  app.add_option("--json", a.json, "file for the report");
  app.add_option("--markdown", a.markdown, "file for the report as a page");
  app.add_option("--fact", a.facts, "KEY=TEXT that the report repeats")->allow_extra_args(false);
  app.add_option("--backend", a.backend, "what is measured")
      ->check(CLI::IsMember({"cuda", "cpu"}))
      ->capture_default_str();
  app.add_option("--warmup", a.warmup, "frames before the measured ones")->check(CLI::Range(1, 1000000));
  app.add_option("--repeats", a.repeats, "frames that are measured")->check(CLI::Range(1, 1000000));
  app.add_option("--threads", a.threads, "on the host, inside a single frame")->check(CLI::Range(1, 1024));
  app.add_option("--in-flight", a.in_flight, "frames at a time")->check(CLI::Range(1, 256));
  app.add_option("--batch-frames", a.batch_frames, "frames of the batch")->check(CLI::Range(1, 100000000));
  try {
    app.parse(argc, argv);
    if (a.device) return facet::name_device();
    return a.make_frames.empty() ? facet::check(a) : facet::make_frames(a.make_frames);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  } catch (const facet::Error& e) {
    fmt::print(stderr, "facet_gpu_check: {}\n", e.what());
    return exit_code_of(e.kind());
  } catch (const std::exception& e) {
    fmt::print(stderr, "facet_gpu_check: {}\n", e.what());
    return 70;
  }
}
