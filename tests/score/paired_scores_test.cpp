#include "score/paired_scores.hpp"

#include <gtest/gtest.h>

#include "score/desk.hpp"
#include "score/truth_prediction.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

constexpr BootstrapOptions quick{200, 1};

/// Twelve frames of which the first, second, ... has `more`, `more` + 1, `more` + 2, `more`, ... of three
/// surfaces found.
ScoreCollection twelve_frames(int more) {
  const FrameTruth frame = frame_truth(desk(), desk_masks(), {});
  ScoreCollection collection;
  for (int i = 0; i < 12; ++i) {
    FrameScore score = score_frame(frame, truth_as_prediction(frame));
    score.surfaces_50.detected = i % 3 + more;
    collection.frames.push_back({score, ""});
  }
  return collection;
}

TEST(PairedScores, ADifferenceOfPairedFramesHasANarrowerIntervalThanEitherScore) {
  const auto scores = pair_scores(twelve_frames(0), twelve_frames(1), quick, {"surface_recall_0.5"});
  ASSERT_EQ(scores.size(), 1u);
  EXPECT_NEAR(*scores[0].change, 1.0 / 3, 1e-12);
  EXPECT_NEAR(scores[0].interval->lo, 1.0 / 3, 1e-12);
  EXPECT_NEAR(scores[0].interval->hi, 1.0 / 3, 1e-12);
  EXPECT_EQ(scores[0].changed, 12);
}

TEST(PairedScores, NamedOnesAreThoseOfAll) {
  const ScoreCollection before = twelve_frames(0), after = twelve_frames(1);
  const auto all = pair_scores(before, after, quick);
  const auto named = pair_scores(before, after, quick, {"surface_precision_0.5", "surface_recall_0.5"});
  ASSERT_EQ(named.size(), 2u);
  for (const PairedScore& score : named)
    for (const PairedScore& other : all)
      if (other.metric == score.metric) {
        EXPECT_EQ(score.change, other.change) << score.metric;
        EXPECT_EQ(score.p, other.p) << score.metric;
      }
}

TEST(PairedScores, RefuseOtherFramesAndUnknownNames) {
  ScoreCollection fewer = twelve_frames(0);
  fewer.frames.pop_back();
  expect_error(ErrorKind::internal, "different frames", [&] { pair_scores(twelve_frames(0), fewer, quick); });
  expect_error(ErrorKind::internal, "beauty",
               [&] { pair_scores(twelve_frames(0), twelve_frames(1), quick, {"beauty"}); });
}

}  // namespace
}  // namespace facet
