#include "dataset/azure_calibration.hpp"

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>
#include <random>

#include "dataset/azure_recording.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

const AzureDepthMode& mode_called(std::string_view name) {
  for (const AzureDepthMode& mode : azure_depth_modes())
    if (mode.name == name) return mode;
  throw std::invalid_argument(std::string(name));
}

LensModel any_lens() {
  return {
      .camera = {504, 505, 318.5f, 330.25f}, .k = {0.9, -2.6, 1.5, 0.8, -2.4, 1.4}, .p1 = 4e-4, .p2 = -3e-4};
}

TEST(AzureCalibration, is_in_pixels_of_the_mode) {
  const LensModel full = azure_depth_lens(calibration_text(), mode_called("NFOV_UNBINNED"), "test");
  EXPECT_EQ(full.camera, (Camera{504, 506, 319.5f, 347.5f}));
  const LensModel wide = azure_depth_lens(calibration_text(), mode_called("WFOV_2X2BINNED"), "test");
  EXPECT_EQ(wide.camera, (Camera{252, 253, 255.5f, 263.5f}));
  EXPECT_EQ(wide.largest_radius, 1.7);
}

TEST(AzureCalibration, tells_the_two_tangential_models_apart) {
  const AzureDepthMode& mode = mode_called("NFOV_UNBINNED");
  EXPECT_FALSE(azure_depth_lens(calibration_text(), mode, "test").halved_cross_terms);
  EXPECT_TRUE(azure_depth_lens(calibration_text(0, "Rational6KT"), mode, "test").halved_cross_terms);
}

TEST(AzureCalibration, takes_the_terminator_that_the_recorder_attaches) {
  const std::string text = calibration_text() + std::string(1, '\0');
  EXPECT_EQ(azure_depth_lens(text, mode_called("NFOV_UNBINNED"), "test").camera.fx, 504);
}

TEST(AzureCalibration, refuses_what_is_none) {
  const AzureDepthMode& mode = mode_called("NFOV_UNBINNED");
  for (const char* text : {"", "[]", "{\"CalibrationInformation\": {\"Cameras\": []}}"})
    expect_error(ErrorKind::data, "here: no ", [&] { azure_depth_lens(text, mode, "here"); });
  std::string few = calibration_text();
  few.replace(few.find("0.515625, "), 10, "");
  expect_error(ErrorKind::data, "expected 14 or 15", [&] { azure_depth_lens(few, mode, "here"); });
}

TEST(AzureCalibration, takes_any_bytes) {
  std::mt19937 random(5);
  const AzureDepthMode& mode = mode_called("NFOV_2X2BINNED");
  int accepted = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = calibration_text(0.1);
    for (unsigned i = 0; i <= random() % 8; ++i)
      text[random() % text.size()] = static_cast<char>(random() % 256);
    if (round % 3 == 0) text.resize(random() % text.size());
    try {
      undistortion_map(azure_depth_lens(text, mode, "test"), {8, 8});
      ++accepted;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::data);
    }
  }
  EXPECT_GT(accepted, 0);
}

TEST(Lens, distorts_as_opencv_does) {
  const LensModel lens = any_lens();
  const std::vector<double> coefficients{lens.k[0], lens.k[1], lens.p1,   lens.p2,
                                         lens.k[2], lens.k[3], lens.k[4], lens.k[5]};
  for (double y = -0.7; y <= 0.7; y += 0.1)
    for (double x = -0.7; x <= 0.7; x += 0.1) {
      std::vector<cv::Point2d> projected;
      cv::projectPoints(std::vector<cv::Point3d>{{x, y, 1}}, cv::Vec3d(), cv::Vec3d(), cv::Matx33d::eye(),
                        coefficients, projected);
      const auto seen = lens.distort({x, y});
      ASSERT_TRUE(seen);
      EXPECT_NEAR(seen->x, projected[0].x, 1e-12);
      EXPECT_NEAR(seen->y, projected[0].y, 1e-12);
    }
}

TEST(Lens, counts_from_the_centre_of_distortion) {
  LensModel lens = any_lens(), shifted = lens;
  shifted.centre_x = 0.1;
  shifted.centre_y = -0.05;
  const auto a = lens.distort({0.3, 0.2}), b = shifted.distort({0.4, 0.15});
  EXPECT_NEAR(a->x + 0.1, b->x, 1e-12);
  EXPECT_NEAR(a->y - 0.05, b->y, 1e-12);
}

TEST(Lens, shows_nothing_beyond_its_reach) {
  LensModel lens = any_lens();
  lens.largest_radius = 0.5;
  EXPECT_TRUE(lens.distort({0.49, 0}));
  EXPECT_FALSE(lens.distort({0.51, 0}));
}

TEST(Lens, without_distortion_every_pixel_is_its_own) {
  const Size size{31, 7};
  const Image<std::int32_t> map = undistortion_map({.camera = {30, 30, 15, 3}}, size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) EXPECT_EQ(map(x, y), y * size.width + x);
}

TEST(Lens, the_map_leads_to_the_pixel_that_is_nearest) {
  const LensModel lens = any_lens();
  const Size size{640, 576};
  const Image<std::int32_t> map = undistortion_map(lens, size);
  for (int v = 0; v < size.height; v += 13)
    for (int u = 0; u < size.width; u += 13) {
      const auto seen = lens.distort({(u - 318.5) / 504, (v - 330.25) / 505});
      const double x = seen->x * 504 + 318.5, y = seen->y * 505 + 330.25;
      const bool inside = x >= -0.5 && y >= -0.5 && x < size.width - 0.5 && y < size.height - 0.5;
      ASSERT_EQ(map(u, v) >= 0, inside);
      if (!inside) continue;
      EXPECT_LE(std::abs(map(u, v) % size.width - x), 0.5 + 1e-9);
      EXPECT_LE(std::abs(map(u, v) / size.width - y), 0.5 + 1e-9);
    }
}

}  // namespace
}  // namespace facet
