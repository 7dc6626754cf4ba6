#include "truth/frame_annotation.hpp"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"
#include "truth/annotation.hpp"

namespace facet {
namespace {

constexpr Size size{40, 30};

/// Two squares, of the objects 1 and 2, and an edge of object 1.
Truth two_squares() {
  Truth truth{.size = size};
  truth.surfaces.push_back({.number = 1, .object = 1, .parts = {{{{2, 2}, {12, 2}, {12, 12}, {2, 12}}, 0}}});
  truth.surfaces.push_back(
      {.number = 2, .object = 2, .parts = {{{{20, 2}, {30, 2}, {30, 12}, {20, 12}}, 1}}});
  truth.edges.push_back({.number = 1, .object = 1, .kind = EdgeKind::depth, .line = {{2, 2}, {12, 2}}});
  return truth;
}
/// Masks of the two squares, with these values.
Image<std::uint16_t> masks(std::uint16_t left, std::uint16_t right) {
  Image<std::uint16_t> image(size, 0);
  for (int y = 2; y <= 12; ++y)
    for (int x = 2; x <= 12; ++x) image(x, y) = left, image(x + 18, y) = right;
  return image;
}

class FrameAnnotationFiles : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder.path() / name) << text;
  }
  void write_masks(const Image<std::uint16_t>& image) const {
    cv::Mat pixels(image.height(), image.width(), CV_8U);
    for (int y = 0; y < pixels.rows; ++y)
      for (int x = 0; x < pixels.cols; ++x)
        pixels.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(image(x, y));
    cv::imwrite(folder.path() / "f.objects.png", pixels);
  }
  std::optional<FrameAnnotation> read(const Image<std::uint16_t>& given = {}) const {
    return read_frame_annotation(folder.path(), "f", size, given);
  }
  TemporaryFolder folder;
};

TEST_F(FrameAnnotationFiles, AreNothingWhereThereIsNone) {
  EXPECT_FALSE(read().has_value());
  EXPECT_FALSE(read(masks(1, 2)).has_value()) << "masks that came with the frame are no annotation";
}

TEST_F(FrameAnnotationFiles, HoldSurfacesMasksAndPlanes) {
  write("f.json", annotation_text(two_squares(), "f.png"));
  write_masks(masks(1, 2));
  write(
      "f.geometry.json",
      R"({"surfaces": [{"surface": 2, "plane": {"normal": [0, 0, -1], "d_m": 1.5}, "centroid_m": [0, 0, 1.5]},
                         {"surface": 1, "plane": null, "centroid_m": [0.1, 0, 2]}]})");
  const auto annotation = read();
  ASSERT_TRUE(annotation.has_value());
  EXPECT_EQ(annotation->truth->surfaces.size(), 2u);
  EXPECT_EQ(annotation->object_masks(20, 2), 2);
  ASSERT_EQ(annotation->poses.size(), 2u);
  EXPECT_EQ(annotation->poses[0].surface, 2);
  EXPECT_EQ(annotation->poses[0].plane->d_m, 1.5f);
  EXPECT_FALSE(annotation->poses[1].plane.has_value());
  EXPECT_EQ(annotation->files.size(), 3u);
}

TEST_F(FrameAnnotationFiles, MasksBesideTheAnnotationWinOverThoseThatCameWithTheFrame) {
  write("f.json", annotation_text(two_squares(), "f.png"));
  EXPECT_EQ(read(masks(1, 2))->object_masks(2, 2), 1);
  write_masks(masks(1, 2));
  EXPECT_EQ(read(masks(7, 8))->object_masks(2, 2), 1);
}

TEST_F(FrameAnnotationFiles, MasksAloneAreTruthOfObjects) {
  write_masks(masks(3, 4));
  EXPECT_FALSE(read()->truth.has_value());
  EXPECT_EQ(read()->object_masks(2, 2), 3);
}

TEST_F(FrameAnnotationFiles, AGroupThatIsNotItsMaskIsAnErrorThatNamesTheSurface) {
  write("f.json", annotation_text(two_squares(), "f.png"));
  expect_error(ErrorKind::data, "f.json: surface/1: group_id 1, but most of it lies on object mask 2",
               [&] { read(masks(2, 1)); });
  expect_error(ErrorKind::data, "f.json: group_id 2 has no pixel in the object masks",
               [&] { read(masks(1, 0)); });
}

TEST_F(FrameAnnotationFiles, MasksOfAnotherSizeOrTypeAndBrokenGeometryAreErrors) {
  write("f.json", annotation_text(two_squares(), "f.png"));
  cv::imwrite(folder.path() / "f.objects.png", cv::Mat(8, 9, CV_8U, cv::Scalar(1)));
  expect_error(ErrorKind::data, "f.objects.png: 9 x 8 px, but the frame has 40 x 30", [&] { read(); });
  cv::imwrite(folder.path() / "f.objects.png", cv::Mat(30, 40, CV_8UC3, cv::Scalar(1, 1, 1)));
  expect_error(ErrorKind::data, "expected one channel", [&] { read(); });
  write_masks(masks(1, 2));
  write("f.geometry.json", "{\"surfaces\": [{}]}");
  expect_error(ErrorKind::data, "f.geometry.json: expected surfaces", [&] { read(); });
}

TEST(ShippedAnnotations, KeepEveryRuleAndAgreeWithTheirMasks) {
  for (const std::string name : {"learn6", "test42", "test63"}) {
    const auto annotation = read_frame_annotation(FACET_DATASETS "/osd/annotations", name, {640, 480}, {});
    ASSERT_TRUE(annotation.has_value()) << name;
    EXPECT_TRUE(annotation->truth.has_value());
    EXPECT_FALSE(annotation->object_masks.empty());
  }
}

}  // namespace
}  // namespace facet
