#include "overlay/overlay.hpp"

#include <gtest/gtest.h>

#include "file/file_bytes.hpp"
#include "overlay/example_frame.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

TEST(Overlay, draws_images_of_every_size) {
  for (const Size size :
       {Size{1, 1}, Size{31, 7}, Size{9, 33}, Size{631, 479}, Size{1920, 1080}, Size{3000, 1}}) {
    const cv::Mat picture = draw_overlay(example_frame(size), half_prediction(size));
    EXPECT_EQ(picture.type(), CV_8UC3);
    EXPECT_EQ(picture.cols, 3 * 640 + 4 * 10) << size.width << "x" << size.height;
  }
}

TEST(Overlay, draws_a_frame_in_which_nothing_was_measured_or_found) {
  const Size size{64, 48};
  Frame frame = example_frame(size);
  frame.depth_m.fill(0);
  Prediction prediction = empty_prediction(size);
  prediction.edges = Image<std::uint8_t>();
  prediction.note = "no depth";
  EXPECT_FALSE(draw_overlay(frame, prediction).empty());
}

TEST(Overlay, the_same_frame_gives_the_same_file) {
  const TemporaryFolder folder;
  const Size size{64, 48};
  write_overlays(example_frame(size), half_prediction(size), folder.path() / "a");
  write_overlays(example_frame(size), half_prediction(size), folder.path() / "b");
  const auto bytes = read_file_bytes(folder.path() / "a" / "example.png");
  EXPECT_EQ(bytes, read_file_bytes(folder.path() / "b" / "example.png"));
}

TEST(Overlay, images_that_do_not_fit_each_other_are_refused) {
  const Frame frame = example_frame({8, 6});
  expect_error(ErrorKind::internal, "differ in size", [&] { draw_overlay(frame, empty_prediction({8, 5})); });
  Prediction prediction = empty_prediction({8, 6});
  prediction.surfaces.resize(1);
  prediction.surfaces[0].id = 3;
  expect_error(ErrorKind::internal, "surface 3 is not in the label image",
               [&] { draw_overlay(frame, prediction); });
}

}  // namespace
}  // namespace facet
