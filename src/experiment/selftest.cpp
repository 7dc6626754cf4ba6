#include "experiment/selftest.hpp"

#include <cmath>
#include <fmt/format.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "score/summary.hpp"
#include "score/truth_prediction.hpp"

namespace facet {
namespace {

std::optional<FrameTruth> truth_of(const Dataset& data, std::size_t index) {
  const Frame frame = data.load(index);
  std::optional<FrameAnnotation> annotation = data.annotation(index, frame);
  if (!annotation) return std::nullopt;
  if (!annotation->truth) return frame_truth(annotation->object_masks, frame.depth_m);
  return frame_truth(*annotation->truth, annotation->object_masks, frame.depth_m, annotation->poses);
}

void add_metric(const ScoreCollection& collection, const Metric& metric, const MetricSummary& summary,
                Selftest& test) {
  if (!summary.micro) {
    test.text += fmt::format("{:<44} n/a: {}\n", metric.name,
                             summary.not_provided.empty() ? "nothing to count" : summary.not_provided);
    return;
  }
  const double perfect = metric.less_is_better ? 0 : 1;
  const bool holds = std::abs(*summary.micro - perfect) < 1e-9;
  test.text +=
      fmt::format("{:<44} {:8.3f} %  {}\n", metric.name, 100 * *summary.micro, holds ? "ok" : "WRONG");
  if (!holds)
    test.problems.push_back(fmt::format("{}: {:.6f} over {} frames, expected {}", metric.name, *summary.micro,
                                        collection.frames.size(), perfect));
}

}  // namespace

Selftest run_selftest(const DatasetSpec& spec) {
  const auto data = open_dataset(spec);
  Selftest test;
  ScoreCollection collection;
  for (std::size_t i = 0; i < data->size(); ++i) {
    ++test.frames;
    try {
      const std::optional<FrameTruth> truth = truth_of(*data, i);
      if (!truth) continue;
      ++test.annotated;
      collection.frames.push_back(
          {score_frame(*truth, truth_as_prediction(*truth), {.edges = true, .poses = true, .grasps = true}),
           ""});
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::data) throw;
      test.problems.push_back(escaped_utf8(data->frame_id(i)) + ": " + e.what());
    }
  }
  const ScoreSummary summary = summarise_scores(collection, {.replicates = 1});
  for (const Metric& metric : score_metrics())
    add_metric(collection, metric, summary.metric(metric.name), test);
  test.text += fmt::format("{} of {} frames have truth, {} problems\n", test.annotated, test.frames,
                           test.problems.size());
  return test;
}

}  // namespace facet
