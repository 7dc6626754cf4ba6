// Predictions that other programs wrote: what is accepted, and how each broken rule is named.
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "file/file_bytes.hpp"
#include "prediction/prediction_io.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

class ForeignPrediction : public ::testing::Test {
 protected:
  ForeignPrediction() { write_labels(cv::Mat(2, 3, CV_8U, cv::Scalar(4))); }
  void write_labels(const cv::Mat& labels) { cv::imwrite(files_.labels, labels); }
  void write_edges(const cv::Mat& edges) { cv::imwrite(files_.edges, edges); }
  void write_surfaces(std::string_view json) { write_file_atomically(files_.surfaces, json); }
  Prediction read() const { return read_prediction(stem_); }
  void expect_data_error(const std::string& part) const {
    expect_error(ErrorKind::data, part, [&] { read(); });
  }

  TemporaryFolder folder_;
  std::filesystem::path stem_ = folder_.path() / "frame";
  PredictionFiles files_{stem_};
};

TEST_F(ForeignPrediction, needs_only_an_8_bit_label_image) {
  const Prediction prediction = read();
  ASSERT_EQ(prediction.surfaces.size(), 1u);
  EXPECT_EQ(prediction.surfaces[0].id, 4);
  EXPECT_EQ(prediction.surfaces[0].area_px, 6);
  EXPECT_TRUE(prediction.surfaces[0].touches_border);
  EXPECT_EQ(prediction.surfaces[0].no_pose_reason, "not provided");
  EXPECT_TRUE(prediction.edges.empty());
}

TEST_F(ForeignPrediction, may_list_surfaces_bare_and_only_some_of_them) {
  cv::Mat labels(2, 3, CV_16U, cv::Scalar(4));
  labels.at<std::uint16_t>(0, 0) = 900;
  write_labels(labels);
  write_surfaces(R"([{"id": 900, "graspable": true, "object": 2}])");
  const Prediction prediction = read();
  ASSERT_EQ(prediction.surfaces.size(), 2u);
  EXPECT_EQ(prediction.surfaces[0].id, 4);
  EXPECT_TRUE(prediction.surfaces[1].graspable);
  EXPECT_EQ(prediction.surfaces[1].object, 2);
}

TEST_F(ForeignPrediction, may_give_grasps_without_a_score) {
  write_surfaces(
      R"([{"id": 4, "grasps": [{"contacts_m": [[0, 0, 1], [0.05, 0, 1]], "contacts_px": [[0, 1], [2.5, 1]],
                      "closing_axis": [1, 0, 0], "width_m": 0.05}]}])");
  const Prediction prediction = read();
  ASSERT_EQ(prediction.surfaces[0].grasps.size(), 1u);
  const Grasp& grasp = prediction.surfaces[0].grasps[0];
  EXPECT_EQ(grasp.contacts_m[1], (Vec3{0.05f, 0, 1}));
  EXPECT_EQ(grasp.contacts_px[1], (ImagePoint{2.5, 1}));
  EXPECT_EQ(grasp.closing_axis, (Vec3{1, 0, 0}));
  EXPECT_EQ(grasp.width_m, 0.05f);
  EXPECT_EQ(grasp.score, 0);
}

TEST_F(ForeignPrediction, with_a_wrong_grasp_is_an_error_that_names_the_place) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {R"({})", "[0].grasps[0]: 'contacts_m' is missing"},
      {R"({"contacts": 1})", "[0].grasps[0]: unknown name 'contacts'"},
      {R"({"contacts_m": [[0, 0, 1]], "contacts_px": []})", "[0].grasps[0].contacts_m: expected 2 points"},
      {R"({"contacts_m": [[0, 0, 1], [0, 0, 1]], "contacts_px": [[1, 2]]})",
       "[0].grasps[0].contacts_px: expected 2 points"},
      {R"({"contacts_m": [[0, 0, 1], [0, 0]], "contacts_px": [[1, 2], [3, 4]]})",
       "[0].grasps[0].contacts_m[1]: expected 3 numbers"},
      {R"({"contacts_m": [[0, 0, 1], [0, 0, 1]], "contacts_px": [[1, 2], [3, "4"]]})",
       "[0].grasps[0].contacts_px[1][1]: expected a number"},
      {R"({"contacts_m": [[0, 0, 1], [0, 0, 1]], "contacts_px": [[1, 2], [3, 4]], "closing_axis": [1, 0, 0]})",
       "[0].grasps[0]: 'width_m' is missing"},
  };
  for (const auto& [grasp, part] : cases) {
    write_surfaces(R"([{"id": 4, "grasps": [)" + grasp + "]}]");
    expect_data_error(part);
  }
  write_surfaces(R"([{"id": 4, "grasps": 3}])");
  expect_data_error("[0].grasps: expected a list");
}

TEST_F(ForeignPrediction, without_a_label_image_is_an_error) {
  std::filesystem::remove(files_.labels);
  expect_data_error("frame.labels.png: file is missing");
}

TEST_F(ForeignPrediction, with_colour_labels_is_an_error) {
  write_labels(cv::Mat(2, 3, CV_8UC3, cv::Scalar(1, 2, 3)));
  expect_data_error("expected an 8-bit or 16-bit grey PNG, this is a 8-bit colour image");
}

TEST_F(ForeignPrediction, with_palette_labels_is_an_error) {
  // A 1x1 palette image.
  const std::string_view hex =
      "89504e470d0a1a0a0000000d494844520000000100000001080300000028cb34bb0000"
      "0003504c5445ff000019e209370000000a49444154789c636000000002000148afa471"
      "0000000049454e44ae426082";
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16)));
  write_file_atomically(files_.labels, bytes);
  expect_data_error("8-bit palette image");
}

TEST_F(ForeignPrediction, with_float_labels_is_an_error) {
  cv::imwrite(folder_.path() / "labels.tiff", cv::Mat(2, 3, CV_32F, cv::Scalar(1)));
  std::filesystem::rename(folder_.path() / "labels.tiff", files_.labels);
  expect_data_error("this is no PNG file");
}

TEST_F(ForeignPrediction, with_bilevel_labels_is_an_error_for_they_would_read_as_255) {
  cv::imwrite(files_.labels, cv::Mat(2, 3, CV_8U, cv::Scalar(255)), {cv::IMWRITE_PNG_BILEVEL, 1});
  expect_data_error("1-bit grey image");
}

TEST_F(ForeignPrediction, broken_off_is_an_error_at_every_byte) {
  const auto whole = read_file_bytes(files_.labels);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    write_file_atomically(files_.labels, std::span(whole).first(size));
    expect_data_error("frame.labels.png: ");
  }
}

TEST_F(ForeignPrediction, with_an_unknown_edge_code_is_an_error) {
  for (const int code : {4, 15, 16, 20, 33, 255}) {
    cv::Mat edges(2, 3, CV_8U, cv::Scalar(17));
    edges.at<std::uint8_t>(1, 2) = static_cast<std::uint8_t>(code);
    write_edges(edges);
    expect_data_error("frame.edges.png: unknown edge code " + std::to_string(code) + " at pixel (2, 1)");
  }
}

TEST_F(ForeignPrediction, with_edges_of_another_size_or_type_is_an_error) {
  write_edges(cv::Mat(3, 3, CV_8U, cv::Scalar(1)));
  expect_data_error("is 3x3 but the label image is 3x2");
  write_edges(cv::Mat(2, 3, CV_16U, cv::Scalar(1)));
  expect_data_error("expected an 8-bit grey PNG, this is a 16-bit grey image");
}

TEST_F(ForeignPrediction, with_wrong_json_is_an_error_that_names_the_place) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"{", "is not valid JSON"},
      {"3", "expected an object"},
      {"{}", "'surfaces' is missing"},
      {R"({"surfaces": [], "extra": 1})", "unknown name 'extra'"},
      {R"([{"id": 4, "colour": 1}])", "[0]: unknown name 'colour'"},
      {R"([{}])", "[0]: 'id' is missing"},
      {R"([{"id": "4"}])", "[0].id: expected an integer"},
      {R"([{"id": 4.5}])", "[0].id: expected an integer"},
      {R"([{"id": 9999999999}])", "[0].id: is out of range"},
      {R"([{"id": 5}])", "surface 5 is not in the label image"},
      {R"([{"id": 0}])", "surface 0 is not in the label image"},
      {R"([{"id": 4}, {"id": 4}])", "surface 4 is not in the label image, or is listed twice"},
      {R"([{"id": 4, "area_px": 5}])", "area_px is 5 but the label image has 6"},
      {R"([{"id": 4, "area_px": 0}])", "[0].area_px: expected a positive number"},
      {R"([{"id": 4, "curved": 1}])", "[0].curved: expected true or false"},
      {R"([{"id": 4, "plane": {"normal": [0, 1], "d_m": 1}}])", "[0].plane.normal: expected 3 numbers"},
      {R"([{"id": 4, "plane": {"normal": [0, 0, -1]}}])", "[0].plane: 'd_m' is missing"},
      {R"([{"id": 4, "pose": {"centre_m": [0, 0, null], "quaternion_wxyz": [1, 0, 0, 0]}}])",
       "[0].pose.centre_m[2]: expected a number"},
      {R"([{"id": 4, "contour": {"outer": [[3, 0]]}}])",
       "[0].contour.outer[0]: the point lies outside the image"},
      {R"([{"id": 4, "rms_m": 1e99}])", "is not valid JSON"},
      {R"({"surfaces": [], "rejected": [{"seed": [0, 0], "area_px": 1, "reason": 2}]})",
       "rejected[0].reason: expected a text"},
  };
  for (const auto& [json, part] : cases) {
    write_surfaces(json);
    expect_data_error("frame.surfaces.json: ");
    expect_data_error(part);
  }
}

}  // namespace
}  // namespace facet
