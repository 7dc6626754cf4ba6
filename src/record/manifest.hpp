#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace facet {

/// How far a run came.
enum class RunStatus {
  running,   ///< started; stays where a run was killed
  complete,  ///< every frame measured
  partial,   ///< stopped by the user
  failed,    ///< finished or stopped, with failed frames
};
std::string_view status_name(RunStatus status);

/// manifest.json: what was run and what came of it.
struct Manifest {
  static constexpr int schema_version = 1;

  RunStatus status = RunStatus::running;
  std::string experiment;
  std::string study;  ///< "ablation" or "sweep"; empty: the methods as they are
  std::string shard;  ///< "2/4"; empty: the whole
  std::vector<std::string> command;
  std::string config_hash;
  std::string build;
  std::string backend;
  int jobs = 1;
  std::string started_utc;
  std::string finished_utc;  ///< empty while running
  int exit_code = 0;         ///< of the finished run
  std::vector<std::string> methods;
  std::vector<std::string> datasets;
  int frames_planned = 0;  ///< frames times methods
  int frames_ok = 0;
  int frames_data_error = 0;
  int frames_method_error = 0;
  int timing_warmup = 0;
  int timing_repeats = 0;
  int timing_threads = 1;
  std::vector<std::string> notes;  ///< what was asked for and not done, and why
};

std::string to_json(const Manifest& manifest);
/// Throws Error{data} where the text is no manifest or of another schema version.
Manifest manifest_from_json(std::string_view text);

}  // namespace facet
