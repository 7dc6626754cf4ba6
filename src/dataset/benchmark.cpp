#include "dataset/benchmark.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "dataset/benchmark_place.hpp"
#include "dataset/frame_list.hpp"
#include "dataset/frame_loader.hpp"
#include "dataset/verify.hpp"
#include "file/file_bytes.hpp"
#include "synth_io/checksums.hpp"
#include "synth_io/frame_files.hpp"

namespace facet {
namespace {

/// A frame of a benchmark: its part and its place in it.
struct BenchmarkFrame {
  std::string id;
  std::size_t part = 0, place = 0;
};

/// With one part the ids are those of its files; with several, the name of the part goes before them.
std::vector<BenchmarkFrame> list_frames(const std::vector<BenchmarkPart>& parts) {
  std::vector<BenchmarkFrame> frames;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t k = 0; k < parts[p].frames.size(); ++k)
      frames.push_back({(parts.size() > 1 ? parts[p].name + '.' : "") + parts[p].frames[k].id, p, k});
  return frames;
}

std::vector<std::string> ids_of(const std::vector<BenchmarkFrame>& frames) {
  std::vector<std::string> ids;
  for (const BenchmarkFrame& frame : frames) ids.push_back(frame.id);
  return ids;
}

std::string names_of(const std::vector<BenchmarkPart>& parts) {
  std::string names;
  for (const BenchmarkPart& part : parts) names += (names.empty() ? "" : ", ") + part.name;
  return names;
}

/// The parts that the option `set` names: one data set, or a set with all its sequences.
std::vector<BenchmarkPart> selected_parts(const DatasetSpec& spec, std::vector<BenchmarkPart> parts) {
  const auto fail = [&](const std::string& rule) {
    throw Error(ErrorKind::config, "data set '" + spec.name + "': option set: " + rule + names_of(parts));
  };
  if (const auto set = text_option(spec.options, "set")) {
    std::vector<BenchmarkPart> chosen;
    std::copy_if(parts.begin(), parts.end(), std::back_inserter(chosen), [&](const BenchmarkPart& part) {
      return part.name == *set || part.name.starts_with(*set + '/');
    });
    if (chosen.empty()) fail("there is no '" + *set + "' in " + printable(spec.root) + "; there are: ");
    parts = std::move(chosen);
  }
  if (const auto count = number_option(spec.options, "count"))
    for (BenchmarkPart& part : parts)
      std::erase_if(part.frames, [&](const PlannedFrame& frame) { return frame.scene >= *count; });
  for (const BenchmarkPart& part : parts) {
    if (parts.size() > 1 && part.set.frames > 1) fail("sequences are data sets of their own, name one of ");
    if (part.set.sensor.model != parts.front().set.sensor.model && spec.sensor == Sensor::automatic)
      fail("the sets are of different sensors, name one of ");
  }
  return parts;
}

/// What the sets of the parts leave out; with several parts the name of the set goes before it.
std::vector<std::string> absent_from(const std::vector<BenchmarkPart>& parts) {
  std::vector<std::string> absent;
  for (const BenchmarkPart& part : parts) {
    for (const std::string& frame : absent_frames(part.set))
      absent.push_back((parts.size() > 1 ? part.name + '.' : "") + frame);
  }
  return absent;
}

class BenchmarkDataset : public ListedDataset {
 public:
  BenchmarkDataset(const DatasetSpec& spec, Sensor sensor, BenchmarkPlace place,
                   std::vector<BenchmarkPart> parts, std::vector<BenchmarkFrame> frames)
      : ListedDataset(spec, sensor, select_frames(spec, ids_of(frames))),
        place_(std::move(place)),
        parts_(std::move(parts)),
        frames_(std::move(frames)),
        absent_(absent_from(parts_)) {}

  std::string description() const override {
    return "synthetic benchmark '" + place_.spec.name + "', " +
           (place_.rendered ? "rendered into " : "written in ") + printable(place_.folder);
  }
  bool is_sequence() const override { return parts_.front().set.frames > 1; }
  std::filesystem::path folder() const override { return place_.folder; }

  /// A sequence is one data set of several: the others' frames are not its own.
  std::vector<std::string> absent() const override {
    return is_sequence() ? std::vector<std::string>() : absent_;
  }

  std::string shortfall(std::size_t index) const override {
    const auto [part, planned] = planned_at(index);
    const std::filesystem::path folder = place_.folder / part.name;
    return has_frame_files(planned.id, folder) ? shortfall_of(planned.id, folder) : "";
  }

  std::optional<FrameLevel> level(std::size_t index) const override {
    const auto [part, planned] = planned_at(index);
    if (part.set.vary == Vary::nothing) return std::nullopt;
    const auto axis = static_cast<std::size_t>(part.set.vary) - 1;
    return FrameLevel{vary_infos()[axis].name, planned.level};
  }

  Frame load(std::size_t index) const override {
    const auto [part, planned] = planned_at(index);
    const std::filesystem::path folder = place_.folder / part.name;
    if (place_.rendered && !has_frame_files(planned.id, folder)) {
      write_file_atomically(place_.folder / "spec.yaml", place_.spec.text);  // says what the folder holds
      write_frame_files(part.set, planned, folder);
    }
    const std::string png = planned.id + ".png";
    const FrameFiles files{folder / "depth" / png, folder / "color" / png,
                           folder / "truth" / (planned.id + ".objects.png")};
    Frame frame = load_frame(frame_id(index), files, {.unit_m = depth_unit_m}, part.set.sensor.camera());
    if (is_sequence()) {
      const PlannedPose pose = planned_pose(part.set, planned);
      frame.timestamp_s = pose.timestamp_s;
      frame.T_world_camera = pose.T_world_camera;
    }
    return frame;
  }

  std::optional<FrameAnnotation> annotation(std::size_t index, const Frame& frame) const override {
    const auto [part, planned] = planned_at(index);
    auto annotation = read_frame_annotation(place_.folder / part.name / "truth", planned.id,
                                            frame.depth_m.size(), masks_of(frame));
    // Where the cache is must not show in results.
    if (annotation && place_.rendered)
      annotation->source = "rendered benchmark '" + place_.spec.name + "', " + part.name;
    return annotation;
  }

 private:
  std::pair<const BenchmarkPart&, const PlannedFrame&> planned_at(std::size_t index) const {
    const std::string id = frame_id(index);
    const auto found = std::find_if(frames_.begin(), frames_.end(),
                                    [&](const BenchmarkFrame& frame) { return frame.id == id; });
    return {parts_[found->part], parts_[found->part].frames[found->place]};
  }
  BenchmarkPlace place_;
  std::vector<BenchmarkPart> parts_;
  std::vector<BenchmarkFrame> frames_;
  std::vector<std::string> absent_;
};

}  // namespace

std::span<const OptionInfo> benchmark_options() {
  static constexpr std::array<OptionInfo, 4> options{{
      {"set", OptionType::text, "one set of the benchmark, or one sequence as SET/SEQUENCE; all without it"},
      {"count", OptionType::number, "scenes of every set and level, fewer than the spec's; all without it"},
      {"seed", OptionType::number, "in place of the spec's; only where the root is a spec"},
      {"cache", OptionType::text,
       "folder for rendered frames, relative to the spec; $XDG_CACHE_HOME/facet or ~/.cache/facet without "
       "it"},
  }};
  return options;
}

std::unique_ptr<Dataset> open_benchmark(const DatasetSpec& spec) {
  BenchmarkPlace place = find_benchmark(spec.root, spec.options);
  std::vector<BenchmarkPart> parts = selected_parts(spec, benchmark_parts(place.spec));
  if (parts.empty()) throw Error(ErrorKind::data, printable(spec.root) + ": holds no frame");
  const Sensor sensor = spec.sensor == Sensor::automatic ? parts.front().set.sensor.model : spec.sensor;
  std::vector<BenchmarkFrame> frames = list_frames(parts);
  return std::make_unique<BenchmarkDataset>(spec, sensor, std::move(place), std::move(parts),
                                            std::move(frames));
}

void inspect_benchmark(const DatasetSpec& spec, DatasetReport& report) {
  const BenchmarkPlace place = find_benchmark(spec.root, spec.options);
  if (place.rendered) return report.notes.push_back("frames are kept in " + printable(place.folder));
  const std::vector<std::string> problems = checksum_problems(place.folder);
  report.notes.push_back("every checksum of " + std::string(checksum_list) + " was compared");
  for (const std::string& problem : problems) report.problems.push_back({"checksums", problem});
}

}  // namespace facet
