#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dataset/registry.hpp"

namespace facet {

/// What came of scoring the truth of a data set as if a method had predicted it.
struct Selftest {
  int frames = 0, annotated = 0;
  std::vector<std::string> problems;  ///< scores that are not perfect, truth that cannot be read
  std::string text;                   ///< the scores, for people
};

/// Scores the truth of every annotated frame as a prediction: every score has to be perfect. `annotations`
/// wins over the data set's own truth.
Selftest run_selftest(const DatasetSpec& spec);

}  // namespace facet
