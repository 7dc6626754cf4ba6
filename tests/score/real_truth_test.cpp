// Truth as prediction on the annotated frames of OSD below FACET_DATA; skipped where they are absent.
#include <gtest/gtest.h>

#include "prediction/label_images.hpp"
#include "score/perfect_score.hpp"
#include "score/truth_prediction.hpp"
#include "support/real_data.hpp"
#include "truth/annotation.hpp"

namespace facet {
namespace {

TEST(RealTruth, AsPredictionIsPerfect) {
  FACET_REQUIRE_DATA("osd/truth");
  const std::filesystem::path osd = real_data_root() / "osd";
  for (const std::string name : {"learn6", "test42", "test63"}) {
    SCOPED_TRACE(name);
    const Image<std::uint16_t> depth_mm = read_label_image(osd / "disparity" / (name + ".png"));
    Image<float> depth_m(depth_mm.size());
    for (int y = 0; y < depth_m.height(); ++y)
      for (int x = 0; x < depth_m.width(); ++x) depth_m(x, y) = 0.001f * depth_mm(x, y);
    const Image<std::uint16_t> masks = read_label_image(osd / "annotation" / (name + ".png"));
    const FrameTruth frame =
        frame_truth(read_annotation(osd / "truth" / (name + ".json"), depth_m.size()), masks, depth_m);
    expect_perfect(score_frame(frame, truth_as_prediction(frame)));
    const FrameTruth masks_alone = frame_truth(masks, depth_m);
    expect_perfect(score_frame(masks_alone, truth_as_prediction(masks_alone)));
  }
}

}  // namespace
}  // namespace facet
