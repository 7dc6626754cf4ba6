#include "method/external.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "file/portable_name.hpp"
#include "method/program.hpp"
#include "method/program_files.hpp"
#include "prediction/prediction_io.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

/// What became of a batch: batch.json in the method's folder.
struct BatchEnd {
  std::size_t frames = 0;
  double wall_ms = 0;
  std::string failure;  ///< empty: none
};

fs::path batch_file(const fs::path& folder) {
  return folder / "batch.json";
}

std::optional<BatchEnd> read_batch_end(const fs::path& folder) {
  if (folder.empty() || !fs::exists(batch_file(folder))) return std::nullopt;
  const auto bytes = read_file_bytes(batch_file(folder));
  try {
    const auto json = nlohmann::json::parse(bytes.begin(), bytes.end());
    return BatchEnd{json.at("frames"), json.at("wall_ms"), json.at("failure")};
  } catch (const nlohmann::json::exception& e) {
    throw Error(ErrorKind::data, printable(batch_file(folder)) + ": " + e.what());
  }
}

void write_batch_end(const fs::path& folder, const BatchEnd& end) {
  const nlohmann::ordered_json json{
      {"frames", end.frames}, {"wall_ms", end.wall_ms}, {"failure", end.failure}};
  write_file_atomically(batch_file(folder), json.dump() + '\n');
}

/// Runs the command; its output is kept in FOLDER/NAME.stdout.txt and .stderr.txt unless it said nothing.
ProgramEnd run_command(const MethodSpec& spec, const ProgramFiles& files, const fs::path& folder,
                       const std::string& name) {
  const fs::path out_log = folder / (name + ".stdout.txt"), err_log = folder / (name + ".stderr.txt");
  fs::create_directories(folder);
  const ProgramEnd end =
      run_program({filled_command(spec.external, files), spec.folder, fs::absolute(out_log),
                   fs::absolute(err_log), static_cast<double>(spec.external.timeout_s)});
  for (const fs::path& log : {out_log, err_log})
    if (fs::file_size(log) == 0) fs::remove(log);
  return end;
}

/// What an earlier attempt has left must not pass for this one's.
void remove_output(const fs::path& stem) {
  const PredictionFiles files(stem);
  for (const fs::path& file : {files.labels, files.edges, files.surfaces}) fs::remove(file);
}

class ExternalMethod final : public Method {
 public:
  ExternalMethod(const MethodSpec& spec, const MethodContext& context)
      : spec_(spec), folder_(context.folder), batch_(read_batch_end(context.folder)) {}

  void process(const Frame& frame, Prediction& prediction, StageTimes& times) override {
    times = {};
    if (batch_)
      take_from_batch(frame, prediction, times);
    else
      run_alone(frame, prediction, times);
  }
  void reset_history() override {}

 private:
  void run_alone(const Frame& frame, Prediction& prediction, StageTimes& times) const {
    const ScratchFolder scratch;
    const fs::path folder = folder_.empty() ? scratch.path() / "out" : folder_;
    const std::string name = portable_name(frame.id);
    const ProgramFiles folders = ProgramFiles::folders_in(scratch.path(), folder);
    const ProgramFiles files = folders.of_frame(name);
    write_program_input(frame, spec_.external, files);
    remove_output(files.out);
    const bool per_frame = spec_.external.per == ProgramCall::frame;
    const ProgramEnd end = run_command(spec_, per_frame ? files : folders, folder, name);
    if (!end.failure.empty()) throw Error(ErrorKind::data, end.failure);
    prediction = read_output(folder, name, frame.depth_m.size());
    times.total_ms = end.wall_ms;
  }

  void take_from_batch(const Frame& frame, Prediction& prediction, StageTimes& times) const {
    const std::string name = portable_name(frame.id);
    const bool written = fs::exists(PredictionFiles(folder_ / name).labels);
    if (!written && !batch_->failure.empty()) throw Error(ErrorKind::data, batch_->failure);
    prediction = read_output(folder_, name, frame.depth_m.size());
    times.total_ms = batch_->wall_ms / static_cast<double>(batch_->frames);
  }

  /// Messages name the files without their folder, which is another in every run.
  static Prediction read_output(const fs::path& folder, const std::string& name, Size size) {
    if (!fs::exists(PredictionFiles(folder / name).labels))
      throw Error(ErrorKind::data, fmt::format("the program wrote no {}.labels.png", name));
    try {
      return read_prediction(folder / name, size);
    } catch (const Error& e) {
      std::string message = e.what();
      const std::string prefix = printable(folder) + '/';
      if (message.starts_with(prefix)) message.erase(0, prefix.size());
      throw Error(e.kind(), message);
    }
  }

  MethodSpec spec_;
  fs::path folder_;
  std::optional<BatchEnd> batch_;
};

}  // namespace

std::unique_ptr<Method> make_external_method(const MethodSpec& spec, const MethodContext& context) {
  check_command(spec.external, spec.name);
  if (!spec.folder.empty() && !fs::is_directory(spec.folder))
    throw Error(ErrorKind::data,
                "method '" + spec.name + "': " + printable(spec.folder) + ": folder is missing");
  return std::make_unique<ExternalMethod>(spec, context);
}

void run_external_batch(const MethodSpec& spec, const MethodFrames& asked, const MethodContext& context) {
  if (spec.external.per != ProgramCall::batch) return;
  const auto before = read_batch_end(context.folder);
  if (before && before->failure.empty() && before->frames == asked.frames.size()) return;
  const ScratchFolder scratch;
  const ProgramFiles folders = ProgramFiles::folders_in(scratch.path(), context.folder);
  for (const fs::path& folder : {folders.depth, folders.color, folders.intrinsics, folders.out})
    fs::create_directories(folder);
  for (const std::size_t index : asked.frames) {
    const std::string name = portable_name(asked.dataset.frame_id(index));
    remove_output(context.folder / name);
    try {
      write_program_input(asked.dataset.load(index), spec.external, folders.of_frame(name));
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::data) throw;  // a broken frame fails by itself, later
    }
  }
  const ProgramEnd end = run_command(spec, folders, context.folder, "batch");
  write_batch_end(context.folder, {asked.frames.size(), end.wall_ms, end.failure});
}

}  // namespace facet
