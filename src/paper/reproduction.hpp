#pragma once

#include <atomic>
#include <filesystem>
#include <map>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiment/experiment.hpp"
#include "experiment/plan.hpp"
#include "experiment/run_observer.hpp"
#include "experiment/run_options.hpp"
#include "record/run_record.hpp"
#include "report/document.hpp"

namespace facet {

/// What a table or figure of the paper became.
struct Reproduced {
  ReportSection section;
  /// Tables without times: the same on every machine, and compared by --check.
  std::vector<ReportTable> exact;
  bool is_measured = true;  ///< every cell has a value
  std::string latex{};
};

/// What the reproductions of one call share: the runs, made once each, and the folder for pictures.
class Reproduction {
 public:
  Reproduction(bool full, RunOptions options, std::filesystem::path folder, RunObserver& observer,
               const std::atomic<int>& stop_signal);

  /// The record of configs/reproduce/{quick,full}/NAME.yaml, run now unless that was done before. Throws
  /// Error{not_measured} where a signal ended it or no frame was processed.
  const RunRecord& run(const std::string& name);
  bool has_run(const std::string& name) const { return records_.contains(name); }
  /// Experiment and frames of that file without running it.
  std::pair<Experiment, Plan> plan(const std::string& name) const;
  /// Whether the data root holds OSD-0.2, or the folder that is named.
  bool has_data(const std::string& folder) const;
  /// Writes figures/NAME.png, at most `width_px` wide.
  ReportPicture save_picture(const std::string& name, const cv::Mat& picture, const std::string& caption,
                             int width_px = 1600) const;

  bool is_full() const { return full_; }
  const std::filesystem::path& folder() const { return folder_; }
  /// Where the runs are, one line each.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::filesystem::path config(const std::string& name) const;

  bool full_;
  RunOptions options_;
  std::filesystem::path folder_;
  RunObserver& observer_;
  const std::atomic<int>& stop_signal_;
  std::map<std::string, RunRecord> records_;
  std::vector<std::string> notes_;
};

// One function per target; each throws as Reproduction::run() does.
Reproduced reproduce_table2(Reproduction& r);
Reproduced reproduce_table3(Reproduction& r);
Reproduced reproduce_claims(Reproduction& r);
Reproduced reproduce_figure3(Reproduction& r);
Reproduced reproduce_figure4(Reproduction& r);
Reproduced reproduce_figure5(Reproduction& r);
Reproduced reproduce_figure6(Reproduction& r);
Reproduced reproduce_figure10(Reproduction& r);
Reproduced reproduce_figure12(Reproduction& r);
Reproduced reproduce_figure13(Reproduction& r);
Reproduced reproduce_figure14(Reproduction& r);

}  // namespace facet
