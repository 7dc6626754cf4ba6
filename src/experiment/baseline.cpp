#include "experiment/baseline.hpp"

#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pwd.h>
#include <unistd.h>

#include "core/error.hpp"
#include "experiment/run_directory.hpp"
#include "file/file_bytes.hpp"
#include "record/run_record.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

/// What comparisons read; the manifest last, which makes the folder a run.
constexpr std::array stored_files{"frames.jsonl",  "timing/samples.csv",
                                  "timing/io.csv", "timing/calibration.json",
                                  "env.json",      "manifest.json"};

std::string history_line(const BaselineEntry& entry) {
  nlohmann::ordered_json json;
  json["when"] = entry.when_utc;
  json["who"] = entry.who;
  json["reason"] = entry.reason;
  json["run"] = entry.run;
  json["build"] = entry.build;
  json["config_hash"] = entry.config_hash;
  return json.dump() + '\n';
}

}  // namespace

BaselineEntry update_baseline(const fs::path& run, const fs::path& folder, const std::string& reason,
                              const std::string& who) {
  if (reason.find_first_not_of(" \t\n") == std::string::npos)
    throw Error(ErrorKind::usage, "--reason: say why this run becomes the baseline");
  const RunRecord record = read_run(run);
  if (record.manifest.finished_utc.empty() || record.frames.empty())
    throw Error(ErrorKind::data, printable(run) + ": the run is not finished, it cannot be a baseline");
  for (const char* file : stored_files) {
    std::error_code absent;
    if (fs::exists(run / file, absent) && fs::file_size(run / file, absent) > 0)
      write_file_atomically(folder / file, read_file_bytes(run / file));
    else
      fs::remove(folder / file, absent);
  }
  const BaselineEntry entry{escaped_utf8(who),     utc_now(),
                            escaped_utf8(reason),  printable(fs::canonical(run).filename()),
                            record.manifest.build, record.manifest.config_hash};
  LineLog(folder / "history.jsonl").append(history_line(entry));
  return entry;
}

fs::path default_baseline(const fs::path& run) {
  std::error_code failed;
  const fs::path real = fs::canonical(run, failed);
  return (failed ? run : real).parent_path() / "baseline";
}

std::string user_at_machine() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  const passwd* user = ::getpwuid(::geteuid());
  return fmt::format("{}@{}", user != nullptr ? user->pw_name : std::to_string(::geteuid()), host.data());
}

}  // namespace facet
