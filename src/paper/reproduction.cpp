#include "paper/reproduction.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "core/error.hpp"
#include "experiment/data_root.hpp"
#include "experiment/experiment_reader.hpp"
#include "experiment/runner.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"

namespace facet {

namespace fs = std::filesystem;

Reproduction::Reproduction(bool full, RunOptions options, fs::path folder, RunObserver& observer,
                           const std::atomic<int>& stop_signal)
    : full_(full),
      options_(std::move(options)),
      folder_(std::move(folder)),
      observer_(observer),
      stop_signal_(stop_signal) {}

fs::path Reproduction::config(const std::string& name) const {
  const fs::path folder = fs::path(FACET_CONFIGS) / "reproduce";
  const fs::path sized = folder / (full_ ? "full" : "quick") / (name + ".yaml");
  return fs::exists(sized) ? sized : folder / (name + ".yaml");
}

const RunRecord& Reproduction::run(const std::string& name) {
  if (const auto found = records_.find(name); found != records_.end()) return found->second;
  RunOptions options = options_;
  options.config_file = config(name);
  const RunOutcome outcome = run_experiment(options, observer_, stop_signal_);
  if (stop_signal_ != 0) throw Error(ErrorKind::not_measured, "interrupted");
  if (outcome.exit_code == 6) throw Error(ErrorKind::not_measured, name + ": no frame was processed");
  notes_.push_back(fmt::format("{}: {}", name, printable(outcome.directory)));
  return records_.emplace(name, read_run(outcome.directory)).first->second;
}

std::pair<Experiment, Plan> Reproduction::plan(const std::string& name) const {
  Experiment experiment = load_experiment(config(name), options_.overrides).experiment;
  RunOptions options;
  options.data_root = options_.data_root;
  Plan plan = make_plan(experiment, options);
  return {std::move(experiment), std::move(plan)};
}

bool Reproduction::has_data(const std::string& folder) const {
  const auto root = find_data_root(options_.data_root);
  if (!root) return false;
  if (folder != "osd") return fs::is_directory(fs::path(*root) / folder);
  return fs::is_directory(fs::path(*root) / "osd/disparity") ||
         fs::is_directory(fs::path(*root) / "OSD-0.2/disparity");
}

ReportPicture Reproduction::save_picture(const std::string& name, const cv::Mat& picture,
                                         const std::string& caption, int width_px) const {
  cv::Mat shown = picture;
  if (picture.cols > width_px)
    cv::resize(picture, shown, {width_px, picture.rows * width_px / picture.cols}, 0, 0, cv::INTER_AREA);
  const fs::path file = fs::path("figures") / (name + ".png");
  write_png_file(folder_ / file, shown);
  return {caption, file};
}

}  // namespace facet
