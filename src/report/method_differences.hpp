#pragma once

#include <map>
#include <string>
#include <vector>

#include "record/run_record.hpp"
#include "score/paired_scores.hpp"

namespace facet {

/// How the methods of a run differ from its first one on a data set, paired over the frames that both have.
class MethodDifferences {
 public:
  MethodDifferences(const RunRecord& run, const std::string& dataset,
                    const std::vector<std::string>& metrics);
  /// Null for the first method.
  const PairedScore* find(const std::string& method, const std::string& metric) const;
  /// Scored frames of the first method.
  std::size_t frames() const { return frames_; }

 private:
  std::map<std::string, std::vector<PairedScore>> scores_;  ///< by method
  std::size_t frames_ = 0;
};

}  // namespace facet
