#include <fmt/format.h>

#include "compare/comparison.hpp"
#include "score/metrics.hpp"
#include "score/paired_scores.hpp"

namespace facet {
namespace {

/// The frames of one method on one data set, by name.
std::map<std::string, const FrameRow*> rows_of(const RunRecord& run, const MethodOnDataset& what) {
  std::map<std::string, const FrameRow*> rows;
  for (const FrameRow& row : run.frames)
    if (row.method == what.first && row.dataset == what.second) rows[row.frame] = &row;
  return rows;
}

struct PairedFrames {
  ScoreCollection before, after;
  int other_input = 0;  ///< frames whose files differ
  int unscored = 0;     ///< scored on one side alone
};

/// A frame that could not be read has no hash and no score; its counterpart is then unscored as well.
PairedFrames pair_frames(const MethodOnDataset& what, const RunRecord& before, const RunRecord& after,
                         Comparison& out) {
  PairedFrames pairs;
  const auto rows = rows_of(after, what);
  for (const auto& [frame, row] : rows_of(before, what)) {
    const auto found = rows.find(frame);
    if (found == rows.end()) {
      out.vanished.push_back(fmt::format("{} on {}: frame {}", what.first, what.second, frame));
      continue;
    }
    const FrameRow& other = *found->second;
    if (row->score && !other.score)
      out.vanished.push_back(fmt::format("{} on {}: score of frame {}{}{}", what.first, what.second, frame,
                                         other.reason.empty() ? "" : ": ", other.reason));
    if (!row->score != !other.score) ++pairs.unscored;
    if (!row->score || !other.score) continue;
    if (row->input_hash != other.input_hash) ++pairs.other_input;
    const std::string sequence = row->is_sequence ? row->dataset : "";
    pairs.before.frames.push_back({*row->score, sequence});
    pairs.after.frames.push_back({*other.score, sequence});
  }
  return pairs;
}

Better better_of(const PairedScore& score) {
  // A ratio of counts is best at 1, and how near it is depends on the frames.
  if (score.metric == "surface_count_ratio") return Better::same;
  return score_metric(score.metric).less_is_better ? Better::lower : Better::higher;
}

void judge_score(const PairedScore& score, const PairedFrames& pairs, double alpha, ComparedValue& value) {
  const std::string& gone = score.missing_after;
  value.vanished = score.before && !score.after;
  if (!score.before || !score.after) {
    value.reason = value.vanished ? "no value any more: " + gone : "no value before: " + score.missing_before;
    return;
  }
  if (pairs.other_input > 0) {
    value.verdict = Verdict::not_comparable;
    value.reason = fmt::format("{} of {} frames have other input or truth", pairs.other_input,
                               pairs.before.frames.size());
    return;
  }
  const Judgement judgement = judge({*score.before, *score.after, score.interval, score.p, score.n},
                                    value.rule, better_of(score), alpha);
  value.verdict = judgement.verdict;
  value.reason = judgement.reason;
}

}  // namespace

void compare_accuracy(const MethodOnDataset& what, const RunRecord& before, const RunRecord& after,
                      const Policy& policy, const BootstrapOptions& options, Comparison& out) {
  const PairedFrames pairs = pair_frames(what, before, after, out);
  if (pairs.unscored > 0)
    out.notes.push_back(fmt::format("{} on {}: {} frames are scored on one side alone and left out",
                                    what.first, what.second, pairs.unscored));
  if (pairs.before.frames.empty()) return;
  for (const PairedScore& score : pair_scores(pairs.before, pairs.after, options)) {
    const Rule* rule = policy.find(MeasuredKind::accuracy, score.metric);
    if (rule == nullptr || (!score.before && !score.after)) continue;
    ComparedValue value{
        MeasuredKind::accuracy, what.first,     what.second, score.metric, score.before, score.after,
        score.change,           score.interval, score.p,     score.n};
    value.rule = *rule;
    judge_score(score, pairs, policy.alpha, value);
    out.values.push_back(std::move(value));
  }
}

}  // namespace facet
