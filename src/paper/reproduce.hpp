#pragma once

#include <atomic>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/run_observer.hpp"
#include "experiment/run_options.hpp"
#include "report/document.hpp"

namespace facet {

/// What `facet reproduce` is told.
struct ReproduceRequest {
  std::vector<std::string> targets;  ///< names of reproduce_targets(), or all
  bool full = false;                 ///< every scene instead of a few of each kind
  bool check = false;                ///< compare with results/reference/
  RunOptions run;                    ///< out, jobs, data root, overrides
};

struct ReproduceOutcome {
  int exit_code =
      0;  ///< 0 every cell measured; 1 a table differs from its reference; 6 something not measured
  std::filesystem::path directory;
  Report report;
  std::vector<std::string> differences;  ///< from the reference, one line each
};

/// "table2", "claims", "figure12" ...
std::vector<std::string_view> reproduce_targets();

/// Makes the paper's tables, figures and claims from the shipped configs and writes them, with the pictures
/// and LaTeX tables, below OUT/reproduce/. Throws Error{usage} for an unknown target.
ReproduceOutcome reproduce(const ReproduceRequest& request, RunObserver& observer,
                           const std::atomic<int>& stop_signal);

}  // namespace facet
