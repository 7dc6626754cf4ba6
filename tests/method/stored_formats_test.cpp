#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "method/bop_poses.hpp"
#include "method/coco_instances.hpp"
#include "method/registry.hpp"
#include "method/stored_predictions.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

class StoredFormats : public ::testing::Test {
 protected:
  StoredFormats() {
    spec_.name = "theirs";
    spec_.kind = "predictions";
    spec_.folder = folder_.path();
    frame_.id = "000007";
    frame_.depth_m = Image<float>(Size{8, 6}, 1.0f);
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name) << text;
  }
  Prediction process() {
    Prediction prediction;
    StageTimes times;
    make_method(spec_, {})->process(frame_, prediction, times);
    return prediction;
  }

  TemporaryFolder folder_;
  MethodSpec spec_;
  Frame frame_;
};

const std::string pose_header = "scene_id,im_id,obj_id,score,R,t,time\n";

TEST_F(StoredFormats, PosesOfBopBelongToTheLabelOfTheirObject) {
  cv::Mat labels(6, 8, CV_8U, cv::Scalar(0));
  labels.at<std::uint8_t>(2, 3) = 4;
  cv::imwrite((folder_.path() / "000007.labels.png").string(), labels);
  spec_.stored.poses = "poses.csv";
  // A quarter turn about z, and a worse pose of the same surface.
  write("poses.csv", pose_header + "1,7,4,0.9,0 -1 0 1 0 0 0 0 1,100 -20 900,0.1\n" +
                         "1,7,4,0.2,1 0 0 0 1 0 0 0 1,0 0 1,0.1\n1,8,1,1,1 0 0 0 1 0 0 0 1,0 0 1,-1\n");
  const Prediction found = process();
  ASSERT_EQ(found.surfaces.size(), 1u);
  ASSERT_TRUE(found.surfaces[0].pose);
  const SurfacePose& pose = *found.surfaces[0].pose;
  EXPECT_NEAR(pose.centre_m.x, 0.1, 1e-6);
  EXPECT_NEAR(pose.centre_m.z, 0.9, 1e-6);
  EXPECT_NEAR(pose.quaternion_wxyz[0], std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(pose.quaternion_wxyz[3], std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(pose.zyx_deg[0], 90, 1e-4);
  EXPECT_EQ(predictions_without_frame(spec_, {"000007"}), (std::vector<std::string>{"000008"}));
}

TEST_F(StoredFormats, BrokenPosesAreErrorsThatNameTheLine) {
  cv::imwrite((folder_.path() / "000007.labels.png").string(), cv::Mat(6, 8, CV_8U, cv::Scalar(1)));
  spec_.stored.poses = "poses.csv";
  const auto expect = [&](const std::string& row, const std::string& rule) {
    write("poses.csv", pose_header + row);
    expect_error(ErrorKind::data, "poses.csv:2: " + rule, [&] { process(); });
  };
  expect("1,7,1,1,1 0 0 0 1 0 0 0 2,0 0 1,0\n", "R is no rotation");
  expect("1,7,1,1,1 0 0 0 1 0 0 0 -1,0 0 1,0\n", "R is no rotation");
  expect("1,7,1,1,1 0 0 0 1 0 0 0,0 0 1,0\n", "'1 0 0 0 1 0 0 0': expected 9 numbers");
  expect("1,7,1,x,1 0 0 0 1 0 0 0 1,0 0 1,0\n", "'x' is no number");
  expect("1,7,1\n", "3 fields");
  expect("1,7,9,1,1 0 0 0 1 0 0 0 1,0 0 1,0\n", "obj_id 9 is no label");
  spec_.stored.poses = "nowhere.csv";
  expect_error(ErrorKind::data, "nowhere.csv", [&] { process(); });
}

TEST_F(StoredFormats, TheRunLengthsOfCocoAreThoseOfItsOwnWriter) {
  // Written by the published rleToString() of COCO's maskApi.c.
  EXPECT_EQ(decode_coco_runs("=33000a0"), (std::vector<long>{13, 3, 3, 3, 3, 3, 20}));
  EXPECT_EQ(decode_coco_runs("T351Q2gm2"), (std::vector<long>{100, 5, 1, 70, 3000}));
  EXPECT_EQ(decode_coco_runs("`1"), (std::vector<long>{48}));
  EXPECT_EQ(decode_coco_runs("0`1"), (std::vector<long>{0, 48}));
  expect_error(ErrorKind::data, "run lengths", [] { decode_coco_runs("`"); });
  expect_error(ErrorKind::data, "run lengths", [] { decode_coco_runs("!"); });
}

TEST_F(StoredFormats, InstancesOfCocoAreLabelsAndTheSurerOneIsOnTop) {
  spec_.stored.instances = "results.json";
  // Columns 2 to 4 of rows 1 to 3 by counts, twice: the second is surer and one column wide.
  write(
      "results.json",
      R"([{"image_id": 7, "score": 0.5, "segmentation": {"size": [6, 8], "counts": [13, 3, 3, 3, 3, 3, 20]}},
            {"image_id": 7, "score": 0.9, "segmentation": {"size": [6, 8], "counts": [19, 3, 26]}},
            {"image_id": 9, "score": 0.9, "segmentation": {"size": [6, 8], "counts": [48]}}])");
  const Prediction found = process();
  ASSERT_EQ(found.surfaces.size(), 2u);
  EXPECT_EQ(found.surfaces[0].area_px, 6);
  EXPECT_EQ(found.surfaces[1].area_px, 3);
  EXPECT_EQ(found.labels(2, 1), 1);
  EXPECT_EQ(found.labels(3, 2), 2);
  EXPECT_EQ(found.labels(4, 3), 1);
  EXPECT_EQ(found.labels(4, 4), 0);
  EXPECT_EQ(predictions_without_frame(spec_, {"000007"}), (std::vector<std::string>{"000009"}));
}

TEST_F(StoredFormats, AWholeDataSetOfCocoNamesItsFramesByTheirFiles) {
  spec_.stored.instances = "set.json";
  write("set.json",
        R"({"images": [{"id": 1, "file_name": "000007.png"}, {"id": 2, "file_name": "000008.png"}],
    "annotations": [{"image_id": 1, "segmentation": [[1, 1, 5, 1, 5, 4, 1, 4]]}]})");
  const Prediction found = process();
  ASSERT_EQ(found.surfaces.size(), 1u);
  EXPECT_EQ(found.labels(2, 2), 1);
  EXPECT_EQ(found.labels(7, 5), 0);
  frame_.id = "000008";
  EXPECT_TRUE(process().surfaces.empty());
}

TEST_F(StoredFormats, BrokenInstancesAreErrorsThatNameTheFile) {
  spec_.stored.instances = "results.json";
  const auto expect = [&](const std::string& text, const std::string& rule) {
    write("results.json", text);
    expect_error(ErrorKind::data, rule, [&] { process(); });
  };
  expect("[{", "results.json");
  expect(R"([{"image_id": 7}])", "segmentation");
  expect(R"([{"image_id": 7, "segmentation": {"size": [8, 6], "counts": [48]}}])", "its size");
  expect(R"([{"image_id": 7, "segmentation": {"size": [6, 8], "counts": [40]}}])", "do not fill");
  expect(R"([{"image_id": 7, "segmentation": {"size": [6, 8], "counts": [40, 40]}}])", "do not fit");
  expect(R"({"images": [], "annotations": [{"image_id": 3, "segmentation": []}]})", "none of the images");
  spec_.stored.frame_id = "{nonsense}";
  write("results.json", R"([{"image_id": 7, "segmentation": {"size": [6, 8], "counts": [48]}}])");
  expect_error(ErrorKind::config, "frame_id", [&] { process(); });
}

}  // namespace
}  // namespace facet
