#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/run_observer.hpp"
#include "record/run_record.hpp"

namespace facet {

/// Two builds of the program and what both of them run.
struct GateRequest {
  std::filesystem::path binary, baseline_binary;
  std::vector<std::string> arguments;  ///< of `run`, the experiment file first; no --out
  std::filesystem::path out;           ///< folder that gets a run directory per build and round
  int rounds = 5;
};

struct GateRounds {
  std::vector<RunRecord> before, after;
};

/// Runs both builds in turn, baseline first in even rounds and last in odd ones, so that what the machine
/// does besides falls on both. Throws Error{data} where a run gives no record, with what the program said; a
/// run with failed frames is a record.
GateRounds run_gate_rounds(const GateRequest& request, const std::string& series, RunObserver& observer);

}  // namespace facet
