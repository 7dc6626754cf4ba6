#include "report/method_differences.hpp"

#include <algorithm>

namespace facet {
namespace {

// Enough for an interval of one decimal; thousands of frames are to be rendered within seconds.
constexpr BootstrapOptions bootstrap{.replicates = 2000};

/// The scores of two methods over the frames that both have.
struct Pairs {
  ScoreCollection first, second;
};
Pairs pairs_of(const RunRecord& run, const std::string& dataset, const std::string& first,
               const std::string& second) {
  std::map<std::string, const FrameRow*> of_first;
  for (const FrameRow& row : run.frames)
    if (row.dataset == dataset && row.method == first && row.score) of_first[row.frame] = &row;
  Pairs pairs;
  for (const FrameRow& row : run.frames) {
    const auto found = of_first.find(row.frame);
    if (row.dataset != dataset || row.method != second || !row.score || found == of_first.end()) continue;
    const std::string sequence = row.is_sequence ? row.dataset : "";
    pairs.first.frames.push_back({*found->second->score, sequence});
    pairs.second.frames.push_back({*row.score, sequence});
  }
  return pairs;
}

}  // namespace

MethodDifferences::MethodDifferences(const RunRecord& run, const std::string& dataset,
                                     const std::vector<std::string>& metrics) {
  const std::vector<std::string>& methods = run.manifest.methods;
  for (const FrameRow& row : run.frames)
    frames_ += row.dataset == dataset && row.method == methods.front() && row.score;
  for (std::size_t i = 1; i < methods.size(); ++i) {
    const Pairs pairs = pairs_of(run, dataset, methods.front(), methods[i]);
    scores_[methods[i]] = pair_scores(pairs.first, pairs.second, bootstrap, metrics);
  }
}

const PairedScore* MethodDifferences::find(const std::string& method, const std::string& metric) const {
  const auto scores = scores_.find(method);
  if (scores == scores_.end()) return nullptr;
  const auto found = std::find_if(scores->second.begin(), scores->second.end(),
                                  [&](const PairedScore& score) { return score.metric == metric; });
  return found == scores->second.end() ? nullptr : &*found;
}

}  // namespace facet
