#include "method/stored_predictions.hpp"

#include <gtest/gtest.h>

#include "prediction/prediction_io.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

MethodSpec spec_of(const std::filesystem::path& folder) {
  MethodSpec spec;
  spec.name = "theirs";
  spec.kind = "predictions";
  spec.folder = folder;
  return spec;
}
Prediction one_label() {
  Prediction prediction;
  prediction.labels = Image<std::uint16_t>(Size{8, 6}, 0);
  for (int x = 1; x < 5; ++x) prediction.labels(x, 2) = 3;
  return prediction;
}

TEST(StoredPredictions, AreReadByFrame) {
  const TemporaryFolder folder;
  write_prediction(one_label(), folder.path() / "f1");
  const auto method = make_method(spec_of(folder.path()), {});
  Frame frame;
  frame.depth_m = Image<float>(Size{8, 6}, 1.0f);
  frame.id = "f1";
  Prediction prediction;
  StageTimes times;
  method->process(frame, prediction, times);
  EXPECT_EQ(prediction.labels(2, 2), 3);
  EXPECT_EQ(times.total_ms, 0);
  frame.id = "f2";
  expect_error(ErrorKind::data, "f2.labels.png", [&] { method->process(frame, prediction, times); });
}

TEST(StoredPredictions, OfAnotherSizeThanTheFrameAreErrors) {
  const TemporaryFolder folder;
  write_prediction(one_label(), folder.path() / "f1");
  Frame frame;
  frame.depth_m = Image<float>(Size{9, 6}, 1.0f);
  frame.id = "f1";
  Prediction prediction;
  StageTimes times;
  expect_error(ErrorKind::data, "f1.labels.png: is 8x6 but the frame is 9x6",
               [&] { make_method(spec_of(folder.path()), {})->process(frame, prediction, times); });
}

TEST(StoredPredictions, NeedAFolderThatIsThere) {
  expect_error(ErrorKind::config, "needs a folder", [] { make_method(spec_of(""), {}); });
  expect_error(ErrorKind::data, "nowhere: folder is missing", [] { make_method(spec_of("nowhere"), {}); });
}

TEST(StoredPredictions, ThatBelongToNoFrameAreListed) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "sub");
  for (const char* id : {"f1", "f2", "sub/f3"}) write_prediction(one_label(), folder.path() / id);
  EXPECT_EQ(predictions_without_frame(spec_of(folder.path()), {"f1"}),
            (std::vector<std::string>{"f2", "sub/f3"}));
}

}  // namespace
}  // namespace facet
