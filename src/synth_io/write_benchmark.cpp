#include "synth_io/write_benchmark.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "synth/frame_plan.hpp"
#include "synth_io/benchmark_folder.hpp"
#include "synth_io/frame_files.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

std::string sensor_name(Sensor sensor) {
  return sensor == Sensor::azure_kinect ? "azure_kinect" : sensor == Sensor::stereo ? "stereo" : "kinect_v1";
}

std::string dataset_text(const SetSpec& set) {
  const Camera c = set.sensor.camera();
  const auto text = [](float v) {  // the shortest that reads back as the same number
    std::array<char, 32> digits{};
    return std::string(digits.data(), std::to_chars(digits.begin(), digits.end(), v).ptr);
  };
  return "depth: \"depth/{id}.png\"\ncolor: \"color/{id}.png\"\ndepth_unit_m: 0.0001\nintrinsics: [" +
         text(c.fx) + ", " + text(c.fy) + ", " + text(c.cx) + ", " + text(c.cy) +
         "]\nregistered: true\nsequence: " + (set.frames > 1 ? "true" : "false") +
         "\nsensor: " + sensor_name(set.sensor.model) + "\n";
}

/// One frame to write.
struct Task {
  const SetSpec* set = nullptr;
  PlannedFrame planned;
  fs::path folder;
};

/// Runs the tasks on `jobs` threads; the first error stops the rest and is thrown.
void run_tasks(const std::vector<Task>& tasks, int jobs, const std::function<void(std::size_t)>& progress) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr error;
  std::size_t done = 0;
  const auto work = [&] {
    for (std::size_t k = next++; k < tasks.size(); k = next++) {
      try {
        const Task& task = tasks[k];
        if (!has_frame_files(task.planned.id, task.folder)) {
          write_frame_files(*task.set, task.planned, task.folder);
        }
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!error) error = std::current_exception();
        next = tasks.size();
        return;
      }
      const std::lock_guard lock(mutex);
      ++done;
      if (progress) progress(done);
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int k = 1; k < jobs; ++k) threads.emplace_back(work);
    work();
  }
  if (error) std::rethrow_exception(error);
}

/// One line per frame in the layout of the TUM benchmark: timestamp tx ty tz qx qy qz qw, camera -> world.
std::string pose_line(double timestamp_s, const RigidMotion& m) {
  const double w = 0.5 * std::sqrt(std::max(0.0, 1 + m.ex.x + m.ey.y + m.ez.z));
  const auto part = [&](double diagonal, double difference) {
    return std::copysign(0.5 * std::sqrt(std::max(0.0, 1 + diagonal)), difference);
  };
  const double qx = part(m.ex.x - m.ey.y - m.ez.z, m.ey.z - m.ez.y),
               qy = part(-m.ex.x + m.ey.y - m.ez.z, m.ez.x - m.ex.z),
               qz = part(-m.ex.x - m.ey.y + m.ez.z, m.ex.y - m.ey.x);
  char line[200];
  std::snprintf(line, sizeof line, "%.6f %.9f %.9f %.9f %.9f %.9f %.9f %.9f\n", timestamp_s, m.origin.x,
                m.origin.y, m.origin.z, qx, qy, qz, w);
  return line;
}

void write_folder_files(const Task& first, const std::vector<Task>& tasks) {
  write_file_atomically(first.folder / "dataset.yaml", dataset_text(*first.set));
  if (first.set->frames == 1) return;
  std::string poses = "# timestamp_s tx ty tz qx qy qz qw (camera in the world)\n";
  for (const Task& task : tasks) {
    if (task.folder != first.folder) continue;
    const PlannedPose pose = planned_pose(*task.set, task.planned);
    poses += pose_line(pose.timestamp_s, pose.T_world_camera);
  }
  write_file_atomically(first.folder / "poses.txt", poses);
}

std::vector<Task> plan_tasks(const BenchmarkSpec& spec, const fs::path& out, BenchmarkSummary& summary) {
  std::vector<Task> tasks;
  for (const SetSpec& set : spec.sets) {
    for (PlannedFrame& planned : plan_frames(set)) {
      const fs::path place = fs::path(set.name) / planned.sequence;
      if (!planned.not_available.empty()) {
        summary.not_available.push_back((place / planned.id).generic_string() + ": " + planned.not_available);
        continue;
      }
      const fs::path folder = planned.sequence.empty() ? out / set.name : out / place;
      tasks.push_back({&set, std::move(planned), folder});
    }
  }
  return tasks;
}

}  // namespace

BenchmarkEstimate estimate_benchmark(const BenchmarkSpec& spec) {
  BenchmarkEstimate estimate;
  for (const SetSpec& set : spec.sets) {
    const std::vector<PlannedFrame> frames = plan_frames(set);
    const auto available = static_cast<std::size_t>(std::count_if(
        frames.begin(), frames.end(), [](const PlannedFrame& f) { return f.not_available.empty(); }));
    // A megapixel of depth, colour and truth takes about 1 MB and 0.8 s, a search for a Table 2 row 2 s.
    const double megapixels =
        1e-6 * static_cast<double>(set.sensor.size().area()) * static_cast<double>(available);
    estimate.frames += available;
    estimate.megabytes += megapixels;
    estimate.seconds +=
        0.8 * megapixels + (set.scenes == "table2" ? 2.0 * static_cast<double>(available) : 0);
  }
  return estimate;
}

BenchmarkSummary write_benchmark(const BenchmarkSpec& spec, const fs::path& out, int jobs,
                                 const std::function<void(std::size_t)>& progress) {
  open_benchmark_folder(out, spec);  // before the first frame is rendered
  BenchmarkSummary summary;
  const std::vector<Task> tasks = plan_tasks(spec, out, summary);
  run_tasks(tasks, jobs, progress);
  for (const Task& task : tasks) {
    if (summary.folders.empty() || summary.folders.back() != task.folder) {
      summary.folders.push_back(task.folder);
      write_folder_files(task, tasks);
    }
    const std::string shortfall = shortfall_of(task.planned.id, task.folder);
    if (shortfall.empty()) continue;
    summary.shortfalls.push_back(printable(fs::relative(task.folder, out) / task.planned.id) + ": " +
                                 shortfall);
  }
  summary.frames = tasks.size();
  complete_benchmark_folder(out, spec);
  return summary;
}

}  // namespace facet
